    /* Layers: each is added once, and then follows Kagezou in all that is as it was left. */

    /**
     * @param {CompItem} comp
     * @param {any} wanted
     * @param {string} tag
     * @param {AVItem} source
     */
    function addLayer(comp, wanted, tag, source) {
        var layer = comp.layers.add(source);
        layer.name = wanted.name;
        layer.startTime = 0;
        addEffects(layer, wanted);
        return newEntry(comp, layer, tag);
    }

    /**
     * @param {CompItem} comp
     * @param {AVLayer} layer
     * @param {string} tag
     */
    function newEntry(comp, layer, tag) {
        var entry = { comp: comp, layer: layer, tag: tag, memory: {}, before: {}, isNew: true };
        noteEntry(entry);
        noteMade(tag);
        return entry;
    }

    /**
     * @param {Entry} entry
     * @param {any} wanted
     */
    function updateLayer(entry, wanted) {
        var layer = entry.layer;
        if (!shows(layer, itemsOfFootage(wanted.footage))) {
            foreignNames.push(nameOfEntry(entry));
            return;
        }
        switchOn(entry);
        followTime(entry, wanted.remap);
        var opacity = transformOf(layer, "ADBE Opacity");
        follow(entry, "o", function () {
            animate(opacity, wanted.opacity, layer.startTime);
            if (hasEmpty(wanted.remap)) {
                showHeld(opacity, wanted.remap, layer.startTime);
            }
        });
        followPlace(entry, function () {
            setPlace(entry, wanted.transform);
        });
        follow(entry, "m", function () {
            layer.blendingMode = /** @type {any} */ (BlendingMode[wanted.blend]);
        });
        if (wanted.colors.length > 0) {
            follow(entry, "c", function () {
                setColors(layer, wanted.colors);
            });
        }
        followName(entry, wanted.name);
        if (wanted.label > 0) {
            follow(entry, "l", function () {
                layer.label = wanted.label;
            });
        }
        followBounds(entry);
        followControls(entry, wanted.driven);
        if (mark(propertyOf(layer, "ADBE Marker"), wanted.markers, layer.startTime, entry.memory)) {
            tellLeft(nameOfEntry(entry), "n");
        }
        remember(layer, entry.tag, entry.memory);
        step();
    }

    function followName(entry, name) {
        follow(entry, "h", function () {
            if (entry.layer.name !== name) {
                entry.layer.name = name;
            }
        });
    }

    function followTime(entry, held) {
        follow(entry, "r", function () {
            if (held.length > 0) {
                remap(entry.layer, held, entry.layer.startTime);
            } else if (entry.layer.timeRemapEnabled) {
                entry.layer.timeRemapEnabled = false;
            }
        });
    }

    /* The numbers of a layer that was parented are those of its parent, and one in space is not where Kagezou lays it. */
    function followPlace(entry, work) {
        if (entry.layer.parent !== null || entry.layer.threeDLayer) {
            tellLeft(nameOfEntry(entry), "p");
            return;
        }
        follow(entry, "p", work);
    }

    /* In and out point each by itself, so that both parts of a layer that was split go on; a layer that was slipped has
       times of its own. */
    /** @param {Entry} entry */
    function followBounds(entry) {
        follow(entry, "b", function () {
            if (entry.isNew) {
                entry.layer.startTime = 0;
            }
        });
        if (!isLeft(entry, "b")) {
            return;
        }
        follow(entry, "i", function () {
            entry.layer.inPoint = 0;
        });
        follow(entry, "e", function () {
            entry.layer.outPoint = HAND_OFF.duration;
        });
    }

    /** @param {Entry} entry */
    function switchOn(entry) {
        if (entry.memory.g) {
            if (entry.memory.g === "on") {
                entry.layer.enabled = true;
            }
            entry.memory.g = "";
            if (entry.tag.indexOf("in:united:") !== 0) {
                backNames.push(nameOfEntry(entry));
            }
        }
    }

    /* What the project no longer has is switched off, not deleted: there may be work on it. */
    /** @param {Entry} entry */
    function switchOff(entry) {
        if (!entry.memory.g) {
            /* What was off before is off when it comes back. */
            entry.memory.g = entry.layer.enabled ? "on" : "off";
            entry.layer.enabled = false;
            remember(entry.layer, entry.tag, entry.memory);
            /* What lies within a composition that is switched off itself is not said. */
            if (entry.tag.indexOf("in:united:") !== 0) {
                goneNames.push(nameOfEntry(entry));
            }
        }
    }
