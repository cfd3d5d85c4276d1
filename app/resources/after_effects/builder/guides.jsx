    /* Guides: nulls for ground, light and grounding points. */

    /**
     * @param {CompItem} comp
     * @param {any} wanted
     * @param {string} tag
     * @param {FolderItem} root
     */
    function addNull(comp, wanted, tag, root) {
        var layer = comp.layers.addNull(HAND_OFF.duration);
        layer.name = wanted.name;
        layer.startTime = 0;
        layer.enabled = false;
        transformOf(layer, "ADBE Anchor Point").setValue([0, 0]);
        moveSource(layer, wanted.name, folderOf("Guides", root));
        return newEntry(comp, layer, tag);
    }

    /**
     * @param {Entry} entry
     * @param {any} wanted
     */
    function updateNull(entry, wanted) {
        var layer = entry.layer;
        switchOn(entry);
        followPlace(entry, function () {
            setPosition(layer, wanted.x, wanted.y, originIn(entry.comp));
            animate(transformOf(layer, "ADBE Rotate Z"), wanted.rotation, layer.startTime);
        });
        follow(entry, "k", function () {
            setSliders(layer, wanted.sliders, entry.isNew);
        });
        followName(entry, wanted.name);
        followBounds(entry);
        remember(layer, entry.tag, entry.memory);
    }

    /**
     * @param {AVLayer} layer
     * @param {any[]} sliders
     * @param {boolean} isNew
     */
    function setSliders(layer, sliders, isNew) {
        var effects = effectsOf(layer);
        for (var i = 0; i < sliders.length; i++) {
            if (isNew) {
                effects.addProperty("ADBE Slider Control").name = sliders[i][0];
            }
            /* Adding an effect makes the others' objects stale. */
            var effect = effects.property(sliders[i][0]);
            if (effect !== null) {
                animate(propertyOf(effect, "ADBE Slider Control-0001"), sliders[i][1], layer.startTime);
            }
        }
    }

    /**
     * @param {CompItem} comp
     * @param {string} tag
     */
    function putWhite(comp, tag) {
        var layer = comp.layers.addSolid([1, 1, 1], "White", HAND_OFF.width, HAND_OFF.height, 1, HAND_OFF.duration);
        moveSource(layer, "White", comp.parentFolder);
        var entry = newEntry(comp, layer, tag);
        remember(layer, tag, {});
        return entry;
    }
