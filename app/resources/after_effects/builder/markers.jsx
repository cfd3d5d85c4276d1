    /* Markers of the user stay; ours carry our name as their cue point. One on the same frame takes our words along.
       One of ours that was moved, changed or deleted is the user's: it does not come again. */
    /**
     * @param {Property} property
     * @param {any[]} markers
     * @param {number} shift
     * @param {any} memory
     */
    function mark(property, markers, shift, memory) {
        var here = {};
        var i;
        for (i = property.numKeys; i >= 1; i--) {
            if (property.keyValue(i).cuePointName === "kagezou") {
                var signs = signsOfMarker(property.keyTime(i) - shift, property.keyValue(i).comment);
                here[signs] = true;
                if (isRemembered(memory, signs)) {
                    property.removeKey(i);
                }
            }
        }
        var all = [];
        var kept = false;
        for (i = 0; i < markers.length; i++) {
            var said = signsOfMarker(markers[i].time, markers[i].comment);
            all.push(said);
            if (isRemembered(memory, said) && !here[said] && !isSaidAt(property, markers[i], shift)) {
                kept = true;
            } else if (!here[said] || isRemembered(memory, said)) {
                putMarker(property, markers[i], shift);
            }
        }
        memory.n = all.length > 0 && all.length < 500 ? all.join("/") : "";
        return kept;
    }

    function signsOfMarker(time, comment) {
        return signsOf(roundedTime(time) + " " + comment);
    }

    function isRemembered(memory, signs) {
        return ("/" + (memory.n || "") + "/").indexOf("/" + signs + "/") >= 0;
    }

    /**
     * @param {Property} property
     * @param {number} time
     */
    function markerNear(property, time) {
        var near = property.numKeys > 0 ? property.nearestKeyIndex(time) : 0;
        return near > 0 && Math.abs(property.keyTime(near) - time) * HAND_OFF.frame_rate < 0.5 ? near : 0;
    }

    function isSaidAt(property, marker, shift) {
        var near = markerNear(property, marker.time + shift);
        return near > 0 && property.keyValue(near).comment.indexOf(marker.comment) >= 0;
    }

    /**
     * @param {Property} property
     * @param {any} marker
     * @param {number} shift
     */
    function putMarker(property, marker, shift) {
        var time = marker.time + shift;
        var value = new MarkerValue(marker.comment);
        var near = markerNear(property, time);
        if (near > 0) {
            value = property.keyValue(near);
            time = property.keyTime(near);
            if (value.comment.indexOf(marker.comment) < 0) {
                value.comment = value.comment + "\n" + marker.comment;
            }
        } else {
            value.cuePointName = "kagezou";
            value.duration = marker.duration;
        }
        property.setValueAtTime(time, value);
    }
