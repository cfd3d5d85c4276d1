    /* The character of what others cast on it, by its name, for its layer is the user's own. */
    function characterOf(target, received) {
        var name = received.name.replace(/ received( normal)?$/, "");
        for (var i = 1; i <= target.comp.numLayers; i++) {
            if (target.comp.layer(i).name === name) {
                return target.comp.layer(i);
            }
        }
        return target.below;
    }

    /* A layer is added on top, so the lowest comes first; one that comes later goes over the one it belongs over. */
    /**
     * @param {any} plan
     * @param {CompItem} comp
     * @param {FolderItem} root
     * @param {any} target
     * @param {boolean} isCopy
     */
    function addParts(plan, comp, root, target, isCopy) {
        var lower = null;
        for (var i = 0; i < plan.parts.length; i++) {
            var part = plan.parts[i];
            var isGuide = part.kind === "null" || part.kind === "controls";
            var there = isGuide ? null : carrierIn(comp, part.tag);
            if (there !== null) {
                lower = plan.isTarget && /^(received:|background:set_under$)/.test(part.tag) ? lower : there;
            } else if (plan.added["$" + part.tag]) {
                var entry = addOne(part, comp, root);
                if (entry === null) {
                    continue;
                }
                if (!plan.isFresh && !isCopy) {
                    addedNames.push(nameOfEntry(entry));
                }
                if (part.kind === "layer" && plan.isTarget) {
                    lower = putBeside(entry.layer, part.wanted, target, lower);
                } else if (!isGuide) {
                    putOver(entry.layer, lower);
                    lower = entry.layer;
                }
            }
        }
    }

    function addOne(part, comp, root) {
        if (part.kind === "white") {
            return putWhite(comp, part.tag);
        }
        if (part.kind === "controls") {
            return addControls(comp, part.tag, root);
        }
        if (part.kind === "null") {
            return addNull(comp, part.wanted, part.tag, root);
        }
        var items = itemsOfFootage(part.wanted.footage);
        return items.length === 0 ? null : addLayer(comp, part.wanted, part.tag, /** @type {AVItem} */ (items[0]));
    }

    /**
     * @param {AVLayer} layer
     * @param {Layer} lower
     */
    function putOver(layer, lower) {
        if (lower !== null) {
            layer.moveBefore(withMatte(lower));
        } else {
            layer.moveToEnd();
        }
    }

    /**
     * Until After Effects 23 a track matte is the layer right above, and nothing may come between.
     * @param {any} layer
     * @returns {Layer}
     */
    function withMatte(layer) {
        return layer.trackMatteLayer === undefined && layer.hasTrackMatte ? layer.containingComp.layer(layer.index - 1) : layer;
    }

    /**
     * What is cast on a character right over it; the lowest shadow under the character, and each over the one before.
     * @param {AVLayer} layer
     * @param {any} wanted
     * @param {any} target
     * @param {Layer} lower
     * @returns {Layer} the one that the next goes over
     */
    function putBeside(layer, wanted, target, lower) {
        if (wanted.tag.indexOf("received:") === 0) {
            /* What lies over another of the same goes over that. */
            var other = /:over$/.test(wanted.tag) ? carrierIn(target.comp, coded(wanted.tag.replace(/:over$/, ""))) : null;
            var character = other || characterOf(target, wanted);
            if (character) {
                layer.moveBefore(character);
            }
            return lower;
        }
        if (wanted.tag === "background:set_under") {
            /* Under the background, which is the user's own. */
            layer.moveToEnd();
            return lower;
        }
        if (lower !== null) {
            putOver(layer, lower);
        } else if (target.below) {
            layer.moveAfter(target.below);
        }
        return layer;
    }
