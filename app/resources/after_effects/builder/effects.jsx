    /* Shift Channels: what alpha, red, green and blue are taken from. */
    var ALPHA = 1;
    var RED = 2;
    var FULL_ON = 9;

    /**
     * @param {AVLayer} layer
     * @param {number[]} sources
     */
    function shiftChannels(layer, sources) {
        var effect = effectsOf(layer).addProperty("ADBE Shift Channels");
        for (var i = 0; i < sources.length; i++) {
            propertyOf(effect, "ADBE Shift Channels-000" + (i + 1)).setValue(sources[i]);
        }
    }

    /* What makes a new layer's pictures what they are to be; effects that the user took away never come again. */
    /**
     * @param {AVLayer} layer
     * @param {any} wanted
     */
    function addEffects(layer, wanted) {
        var effects = effectsOf(layer);
        if (wanted.inverted) {
            effects.addProperty("ADBE Invert");
        }
        if (wanted.alpha_shown) {
            shiftChannels(layer, [FULL_ON, ALPHA, ALPHA, ALPHA]);
        }
        if (wanted.colors.length > 0) {
            shiftChannels(layer, [RED]);
            effects.addProperty("ADBE Fill");
        }
    }

    /**
     * @param {AVLayer} layer
     * @param {any[]} colors
     */
    function setColors(layer, colors) {
        var property = fillOf(layer);
        var times = [];
        var values = [];
        for (var i = 0; i < colors.length; i++) {
            times.push(colors[i][0] + layer.startTime);
            values.push([colors[i][1][0], colors[i][1][1], colors[i][1][2], 1]);
        }
        if (property === null) {
            return;
        }
        if (times.length === 1) {
            clearKeys(property);
            property.setValue(values[0]);
        } else {
            hold(property, times, values);
        }
    }
