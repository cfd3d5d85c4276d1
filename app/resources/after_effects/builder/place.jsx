    /* Where layers lie. The canvas of Kagezou begins at an origin of the composition: its corner, unless the user made the
       composition larger or smaller. */
    var origins = {};

    function originIn(comp) {
        return origins["$" + comp.id] || [0, 0];
    }

    /* On whole pixels, as Kagezou lays it; the middle alone would blur it. */
    /**
     * @param {CompItem} comp
     * @param {AVItem} source
     */
    function middleOf(comp, source) {
        var origin = originIn(comp);
        var left = Math.floor((HAND_OFF.width - source.width) / 2);
        var top = Math.floor((HAND_OFF.height - source.height) / 2);
        return [origin[0] + left + source.width / 2, origin[1] + top + source.height / 2];
    }

    /* Any of the nine anchors that the settings of a composition have may have been used: the one by which most layers lie
       as they were left. */
    /**
     * @param {CompItem} comp
     * @param {number[]} before
     * @param {Entry[]} entries
     */
    function findOrigin(comp, before, entries) {
        var best = null;
        var most = -1;
        for (var i = 0; i < 3; i++) {
            for (var j = 0; j < 3; j++) {
                var by = [(comp.width - before[0]) * i / 2, (comp.height - before[1]) * j / 2];
                var count = 0;
                for (var n = 0; n < entries.length; n++) {
                    count += stateOfPlace(entries[n].layer, by) === entries[n].memory.p ? 1 : 0;
                }
                if (count > most) {
                    most = count;
                    best = by;
                }
            }
        }
        return best;
    }

    /**
     * @param {AVLayer} layer
     * @param {number[]} place
     */
    function putInMiddle(layer, place) {
        var position = transformOf(layer, "ADBE Position");
        if (position.dimensionsSeparated) {
            clearKeys(transformOf(layer, "ADBE Position_0"));
            clearKeys(transformOf(layer, "ADBE Position_1"));
            position.dimensionsSeparated = false;
        }
        clearKeys(position);
        position.setValue(place);
        animatePair(transformOf(layer, "ADBE Anchor Point"), { value: [layer.source.width / 2, layer.source.height / 2], keys: [] }, 0);
        animatePair(transformOf(layer, "ADBE Scale"), { value: [100, 100], keys: [] }, 0);
        animate(transformOf(layer, "ADBE Rotate Z"), { value: 0, keys: [] }, 0);
    }

    /* Each number has its curve, as in Kagezou; one curve for the whole place would bend others. */
    /**
     * @param {AVLayer} layer
     * @param {any} x
     * @param {any} y
     * @param {number[]} origin
     */
    function setPosition(layer, x, y, origin) {
        transformOf(layer, "ADBE Position").dimensionsSeparated = true;
        animate(transformOf(layer, "ADBE Position_0"), movedBy(x, origin[0]), layer.startTime);
        animate(transformOf(layer, "ADBE Position_1"), movedBy(y, origin[1]), layer.startTime);
    }

    /**
     * @param {Entry} entry
     * @param {any} wanted
     */
    function setPlace(entry, wanted) {
        var layer = entry.layer;
        if (!wanted) {
            putInMiddle(layer, middleOf(entry.comp, layer.source));
            return;
        }
        setPosition(layer, wanted.x, wanted.y, originIn(entry.comp));
        animatePair(transformOf(layer, "ADBE Anchor Point"), wanted.anchor, layer.startTime);
        animatePair(transformOf(layer, "ADBE Scale"), wanted.scale, layer.startTime);
        animate(transformOf(layer, "ADBE Rotate Z"), wanted.rotation, layer.startTime);
    }
