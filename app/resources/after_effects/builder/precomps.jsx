    /* Compositions that the user made of our layers: within ours, of their size or of the size of our footage. */
    var followers = [];
    var carriers = [];

    /**
     * @param {CompItem} comp
     * @param {CompItem[]} found
     */
    function within(comp, found) {
        for (var i = 1; i <= comp.numLayers; i++) {
            var source = /** @type {AVLayer} */ (comp.layer(i)).source;
            if (source instanceof CompItem && !hasId(found, source)) {
                found.push(source);
                within(source, found);
            }
        }
        return found;
    }

    function findFollowers(instances, ours) {
        var all = [];
        var i;
        for (i = 0; i < instances.length; i++) {
            within(instances[i], all);
        }
        for (i = 0; i < all.length; i++) {
            var isTheUsers = readComment(all[i].comment) === null;
            if (isTheUsers && (entriesIn(all[i]).length > 0 || holds(all[i], ours))) {
                measureComp(all[i]);
                followers.push({ comp: all[i], footage: shownIn(all[i], ours) });
            }
        }
        for (i = 0; i < instances.length; i++) {
            findCarriers(instances[i], ours);
        }
        for (i = 0; i < followers.length; i++) {
            findCarriers(followers[i].comp, ours);
        }
    }

    /* Footage of ours that a composition shows itself; null where there is none. */
    /**
     * @param {CompItem} comp
     * @param {AVItem[]} ours
     */
    function shownIn(comp, ours) {
        for (var i = 1; i <= comp.numLayers; i++) {
            var source = /** @type {AVLayer} */ (comp.layer(i)).source;
            if (source && hasId(ours, source) && sizes["$" + source.id]) {
                return source;
            }
        }
        return null;
    }

    /* The user's own layers of what is to follow, that lie in the middle or end with their composition. */
    /**
     * @param {CompItem} comp
     * @param {AVItem[]} ours
     */
    function findCarriers(comp, ours) {
        for (var i = 1; i <= comp.numLayers; i++) {
            var layer = /** @type {AVLayer} */ (comp.layer(i));
            if (layer.source && readComment(layer.comment) === null && (hasId(ours, layer.source) || isFollower(layer.source))) {
                var isWhole = roundedTime(layer.outPoint) === roundedTime(comp.duration);
                carriers.push({ comp: comp, layer: layer, size: sizeOf(comp) + sizeOf(layer.source), isInMiddle: isInMiddle(comp, layer), isWhole: isWhole });
            }
        }
    }

    function isFollower(item) {
        for (var i = 0; i < followers.length; i++) {
            if (followers[i].comp.id === item.id) {
                return true;
            }
        }
        return false;
    }

    function isCarrier(layer) {
        for (var i = 0; i < carriers.length; i++) {
            if (carriers[i].layer.index === layer.index && carriers[i].comp.id === layer.containingComp.id) {
                return true;
            }
        }
        return false;
    }

    /**
     * @param {CompItem} comp
     * @param {AVLayer} layer
     */
    function isInMiddle(comp, layer) {
        var position = transformOf(layer, "ADBE Position");
        var scale = transformOf(layer, "ADBE Scale");
        var anchor = transformOf(layer, "ADBE Anchor Point");
        var turned = transformOf(layer, "ADBE Rotate Z");
        if (layer.parent !== null || position.dimensionsSeparated || position.numKeys + scale.numKeys + anchor.numKeys + turned.numKeys > 0 || turned.value !== 0) {
            return false;
        }
        for (var i = 0; i < 2; i++) {
            var left = (i === 0 ? comp.width - layer.source.width : comp.height - layer.source.height) / 2;
            if (Math.abs(scale.value[i] - 100) > 0.01 || Math.abs(position.value[i] - anchor.value[i] - left) > 0.51) {
                return false;
            }
        }
        return true;
    }

    /** @param {CompItem} main */
    function updateFollowers(main) {
        for (var i = 0; i < followers.length; i++) {
            followSize(followers[i], main);
            followNumber(followers[i], main, "F");
            followNumber(followers[i], main, "D");
        }
        for (i = 0; i < carriers.length; i++) {
            followCarrier(carriers[i]);
        }
    }

    function followCarrier(carrier) {
        var comp = carrier.comp;
        var layer = carrier.layer;
        unlocked(layer, function () {
            if (carrier.isInMiddle && carrier.size !== sizeOf(comp) + sizeOf(layer.source)) {
                putInMiddle(layer, [
                    Math.floor((comp.width - layer.source.width) / 2) + layer.source.width / 2,
                    Math.floor((comp.height - layer.source.height) / 2) + layer.source.height / 2
                ]);
            }
            if (carrier.isWhole && roundedTime(layer.outPoint) !== roundedTime(comp.duration)) {
                layer.outPoint = comp.duration;
            }
        });
    }

    /**
     * @param {any} follower
     * @param {CompItem} main
     */
    function followSize(follower, main) {
        var comp = follower.comp;
        var now = before(comp).S;
        var isFootages = follower.footage !== null && now === sizes["$" + follower.footage.id].S;
        /* Without layers of ours it was made of the footage alone, leaving all attributes. */
        var isAlone = isFootages && entriesIn(comp).length === 0;
        var like = now === before(main).S && !isAlone ? main : (isFootages ? follower.footage : null);
        if (like !== null && sizeOf(like) !== now) {
            comp.width = like.width;
            comp.height = like.height;
            tellChanged(comp.name, "S");
        } else if (like === null && before(main).S !== sizeOf(main)) {
            tellLeft(comp.name, "S");
        }
    }

    /**
     * @param {any} follower
     * @param {CompItem} main
     * @param {string} name
     */
    function followNumber(follower, main, name) {
        var comp = follower.comp;
        var attribute = name === "F" ? "frameRate" : "duration";
        var old = before(comp)[name];
        var isMains = old === before(main)[name];
        var footage = name === "D" && follower.footage !== null && !follower.footage.mainSource.isStill && old === sizes["$" + follower.footage.id].D ? follower.footage : null;
        if (isMains || footage !== null) {
            comp[attribute] = isMains ? main[attribute] : footage.duration;
            if (SETTINGS[name](comp) !== old) {
                tellChanged(comp.name, name);
            }
        } else if (before(main)[name] !== SETTINGS[name](main)) {
            tellLeft(comp.name, name);
        }
    }
