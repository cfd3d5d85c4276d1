    /* Keys: values over time, from the start of the layer (shift). */
    /** @param {Property} property */
    function clearKeys(property) {
        while (property.numKeys > 0) {
            property.removeKey(property.numKeys);
        }
    }

    /* Time remapping must never be without a key, so the last of the old ones goes when ours are there. */
    /**
     * @param {Property} property
     * @param {number[]} times
     * @param {any[]} values
     */
    function setKeys(property, times, values) {
        while (property.numKeys > 1) {
            property.removeKey(property.numKeys);
        }
        var old = property.numKeys > 0 ? property.keyTime(1) : null;
        property.setValuesAtTimes(times, values);
        if (old === null || property.numKeys === times.length) {
            return;
        }
        for (var i = property.numKeys; i >= 1; i--) {
            if (Math.abs(property.keyTime(i) - old) < 0.000001) {
                property.removeKey(i);
                return;
            }
        }
    }

    /**
     * @param {Property} property
     * @param {any} channel
     * @param {number} shift
     */
    function animate(property, channel, shift) {
        if (channel.keys.length === 0) {
            clearKeys(property);
            property.setValue(channel.value);
            return;
        }
        var times = [];
        var values = [];
        var i;
        for (i = 0; i < channel.keys.length; i++) {
            times.push(channel.keys[i].time + shift);
            values.push(channel.keys[i].value);
        }
        setKeys(property, times, values);
        for (i = 0; i < channel.keys.length; i++) {
            var key = channel.keys[i];
            if (key.into === "BEZIER" || key.out === "BEZIER") {
                var into = new KeyframeEase(key.ease_in[0], key.ease_in[1]);
                var out = new KeyframeEase(key.ease_out[0], key.ease_out[1]);
                property.setTemporalEaseAtKey(i + 1, [into], [out]);
            }
            /* Behind the eases, for these make both sides bezier. */
            property.setInterpolationTypeAtKey(i + 1, interpolationType(key.into), interpolationType(key.out));
        }
    }

    /* Two numbers of one property, with straight lines between places. */
    /**
     * @param {Property} property
     * @param {any} pair
     * @param {number} shift
     */
    function animatePair(property, pair, shift) {
        if (pair.keys.length === 0) {
            clearKeys(property);
            property.setValue(pair.value);
            return;
        }
        var times = [];
        var values = [];
        var i;
        for (i = 0; i < pair.keys.length; i++) {
            times.push(pair.keys[i].time + shift);
            values.push(pair.keys[i].value);
        }
        setKeys(property, times, values);
        for (i = 0; i < pair.keys.length; i++) {
            var key = pair.keys[i];
            if (property.isSpatial) {
                var straight = zeros(property.keyInSpatialTangent(i + 1).length);
                property.setSpatialAutoBezierAtKey(i + 1, false);
                property.setSpatialTangentsAtKey(i + 1, straight, straight);
            } else if (key.into === "BEZIER" || key.out === "BEZIER") {
                var count = property.keyInTemporalEase(i + 1).length;
                property.setTemporalEaseAtKey(i + 1, eases(key.ease_in, count), eases(key.ease_out, count));
            }
            property.setInterpolationTypeAtKey(i + 1, interpolationType(key.into), interpolationType(key.out));
        }
    }

    /**
     * @param {string} name
     * @returns {KeyframeInterpolationType}
     */
    function interpolationType(name) {
        return /** @type {any} */ (KeyframeInterpolationType[name]);
    }

    /** @returns {any} */
    function zeros(count) {
        var made = [];
        for (var i = 0; i < count; i++) {
            made.push(0);
        }
        return made;
    }

    /**
     * A flat layer's scale too has a third number, and wants an ease for it.
     * @returns {any}
     */
    function eases(known, count) {
        var made = [];
        for (var i = 0; i < count; i++) {
            var ease = known[Math.min(i, known.length - 1)];
            made.push(new KeyframeEase(ease[0], ease[1]));
        }
        return made;
    }

    /**
     * @param {Property} property
     * @param {number[]} times
     * @param {any[]} values
     */
    function hold(property, times, values) {
        setKeys(property, times, values);
        for (var i = 1; i <= property.numKeys; i++) {
            property.setInterpolationTypeAtKey(i, KeyframeInterpolationType.HOLD, KeyframeInterpolationType.HOLD);
        }
    }

    /* Held pictures: time remapping. */
    /**
     * @param {AVLayer} layer
     * @param {any[]} held
     * @param {number} shift
     */
    function remap(layer, held, shift) {
        var times = [];
        var pictures = [];
        var last = 0;
        for (var i = 0; i < held.length; i++) {
            last = held[i][1] === null ? last : held[i][1];
            times.push(held[i][0] + shift);
            /* Half a frame in, so that no rounding ever shows the picture before. */
            pictures.push((last + 0.5) / HAND_OFF.frame_rate);
        }
        if (layer.canSetTimeRemapEnabled) {
            layer.timeRemapEnabled = true;
            hold(propertyOf(layer, "ADBE Time Remapping"), times, pictures);
        }
    }

    /* No opacity on empty cels. */
    function showHeld(opacity, held, shift) {
        var times = [];
        var shown = [];
        for (var i = 0; i < held.length; i++) {
            times.push(held[i][0] + shift);
            shown.push(held[i][1] === null ? 0 : 100);
        }
        hold(opacity, times, shown);
    }

    function hasEmpty(held) {
        for (var i = 0; i < held.length; i++) {
            if (held[i][1] === null) {
                return true;
            }
        }
        return false;
    }

    /* The same channel on a canvas that begins elsewhere. */
    function movedBy(channel, by) {
        var keys = [];
        for (var i = 0; i < channel.keys.length; i++) {
            var key = {};
            for (var name in channel.keys[i]) {
                if (channel.keys[i].hasOwnProperty(name)) {
                    key[name] = channel.keys[i][name];
                }
            }
            key.value += by;
            keys.push(key);
        }
        return { value: channel.value + by, keys: keys };
    }
