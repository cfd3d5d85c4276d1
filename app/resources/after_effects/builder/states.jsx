    /* States: short texts of how a layer is. What is not as it was left was changed by the user. */

    /* Rounded past the middle, so that a number that comes back with another last digit is the same. */
    function rounded(number) {
        return Math.round(number * 10 + 0.23);
    }

    /* In milliseconds: frames change with the rate. */
    function roundedTime(seconds) {
        return Math.round(seconds * 1000 + 0.23);
    }

    function numberOf(value, part) {
        return part < 0 ? value : value[part];
    }

    /* Without what an expression makes of it. */
    /** @param {Property} property */
    function plainValue(property) {
        return property.expression ? property.valueAtTime(0, true) : property.value;
    }

    function interpolation(type) {
        return type === KeyframeInterpolationType.HOLD ? "H" : (type === KeyframeInterpolationType.LINEAR ? "L" : "B");
    }

    /**
     * @param {Property} property
     * @param {number} shift
     */
    function stateOf(property, shift) {
        return stateOfPart(property, shift, -1, 0);
    }

    /* Of a property of several numbers one of them, from 0; -1 for a number. A place has one ease for all of them. */
    /**
     * @param {Property} property
     * @param {number} shift
     * @param {number} part
     * @param {number} less
     */
    function stateOfPart(property, shift, part, less) {
        if (property.numKeys === 0) {
            return String(rounded(numberOf(plainValue(property), part) - less));
        }
        var parts = [];
        for (var i = 1; i <= property.numKeys; i++) {
            var into = property.keyInTemporalEase(i);
            var out = property.keyOutTemporalEase(i);
            var ease = Math.min(Math.max(part, 0), into.length - 1);
            parts.push(roundedTime(property.keyTime(i) - shift), rounded(numberOf(property.keyValue(i), part) - less));
            parts.push(interpolation(property.keyInInterpolationType(i)), interpolation(property.keyOutInterpolationType(i)));
            parts.push(rounded(into[ease].influence), rounded(out[ease].influence));
        }
        return checksum(parts.join(" "));
    }

    /* How a layer lies, moves and turns, with the canvas moved back by less. */
    /**
     * @param {AVLayer} layer
     * @param {number[]} less
     */
    function stateOfPlace(layer, less) {
        var shift = layer.startTime;
        var position = transformOf(layer, "ADBE Position");
        var parts = [stateOf(transformOf(layer, "ADBE Rotate Z"), shift)];
        for (var part = 0; part < 2; part++) {
            parts.push(stateOfPart(transformOf(layer, "ADBE Anchor Point"), shift, part, 0), stateOfPart(transformOf(layer, "ADBE Scale"), shift, part, 0));
            parts.push(position.dimensionsSeparated ? stateOfPart(transformOf(layer, "ADBE Position_" + part), shift, -1, less[part]) : "one" + stateOfPart(position, shift, part, less[part]));
        }
        return checksum(parts.join(" "));
    }

    /** @param {AVLayer} layer */
    function stateOfBlend(layer) {
        var names = ["NORMAL", "MULTIPLY", "LIGHTEN", "SCREEN", "ADD"];
        for (var i = 0; i < names.length; i++) {
            if (layer.blendingMode === BlendingMode[names[i]]) {
                return names[i];
            }
        }
        return "other";
    }

    /* The colour of a united shadow, null where the user took the effect away. */
    /** @param {AVLayer} layer */
    function fillOf(layer) {
        var effects = effectsOf(layer);
        for (var i = 1; i <= effects.numProperties; i++) {
            if (effects.property(i).matchName === "ADBE Fill") {
                return propertyOf(effects.property(i), "ADBE Fill-0002");
            }
        }
        return null;
    }

    /** @param {AVLayer} layer */
    function stateOfColors(layer) {
        var property = fillOf(layer);
        if (property === null) {
            return "none";
        }
        var parts = [];
        for (var i = 1; i <= Math.max(property.numKeys, 1); i++) {
            var color = property.numKeys > 0 ? property.keyValue(i) : plainValue(property);
            parts.push(property.numKeys > 0 ? roundedTime(property.keyTime(i) - layer.startTime) : 0);
            for (var j = 0; j < 3; j++) {
                parts.push(Math.round(color[j] * 255));
            }
        }
        return checksum(parts.join(" "));
    }

    /* Of all sliders of a guide, by their names. */
    /** @param {AVLayer} layer */
    function stateOfSliders(layer) {
        var effects = effectsOf(layer);
        var parts = [];
        for (var i = 1; i <= effects.numProperties; i++) {
            var slider = propertyOf(effects.property(i), "ADBE Slider Control-0001");
            parts.push(effects.property(i).name, slider === null ? "none" : stateOf(slider, layer.startTime));
        }
        return checksum(parts.join(" "));
    }

    /* By one letter each, which is what comments call them. */
    var STATES = {
        o: function (layer) {
            return stateOf(transformOf(layer, "ADBE Opacity"), layer.startTime);
        },
        p: function (layer) {
            return stateOfPlace(layer, [0, 0]);
        },
        r: function (layer) {
            return layer.timeRemapEnabled ? stateOf(propertyOf(layer, "ADBE Time Remapping"), layer.startTime) : "off";
        },
        m: stateOfBlend,
        c: stateOfColors,
        b: function (layer) {
            return String(roundedTime(layer.startTime));
        },
        i: function (layer) {
            return String(roundedTime(layer.inPoint));
        },
        e: function (layer) {
            return String(roundedTime(layer.outPoint));
        },
        l: function (layer) {
            return String(layer.label);
        },
        k: stateOfSliders,
        h: function (layer) {
            return checksum(layer.name);
        }
    };
