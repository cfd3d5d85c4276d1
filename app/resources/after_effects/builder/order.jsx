    /* The order of our layers within a composition: as long as it is as it was left it follows; the
       user's own layers are not moved. */

    /**
     * From the bottom up, as Kagezou has them.
     * @param {any} plan
     * @param {CompItem} comp
     * @returns {Entry[]}
     */
    function ownLayers(plan, comp) {
        var found = [];
        for (var i = 0; i < plan.parts.length; i++) {
            var same = plan.parts[i].kind === "layer" ? entriesOf(plan.parts[i].tag) : [];
            for (var j = 0; j < same.length; j++) {
                if (same[j].comp.id === comp.id) {
                    found.push(same[j]);
                }
            }
        }
        return found;
    }

    /* The signs of tags, each once, with a space behind each. */
    function orderOf(things) {
        var order = "";
        for (var i = 0; i < things.length; i++) {
            var signs = signsOf(things[i].tag);
            if (!isIn(order, signs)) {
                order += signs + " ";
            }
        }
        return order;
    }

    function isIn(order, signs) {
        return (" " + order).indexOf(" " + signs + " ") >= 0;
    }

    function onlyOf(order, other) {
        var kept = "";
        var parts = order.split(" ");
        for (var i = 0; i < parts.length; i++) {
            if (parts[i] !== "" && isIn(other, parts[i])) {
                kept += parts[i] + " ";
            }
        }
        return kept;
    }

    function orderNow(ours) {
        var sorted = ours.slice(0);
        sorted.sort(function (one, other) {
            return other.layer.index - one.layer.index;
        });
        return orderOf(sorted);
    }

    /**
     * Before layers are added.
     * @param {any} plan
     * @param {CompItem} comp
     */
    function followOrder(plan, comp) {
        var read = readComment(comp.comment);
        var ours = ownLayers(plan, comp);
        var wanted = orderOf(ours);
        var last = (read.memory.u || "").replace(/(.{4})/g, "$1 ");
        var before = onlyOf(last, wanted);
        if (onlyOf(wanted, last) !== before) {
            if (onlyOf(orderNow(ours), last) !== before || !reorder(ours)) {
                tellLeft(comp.name, "u");
            } else {
                tellChanged(comp.name, "u");
            }
        }
        read.memory.u = orderOf(layersOnly(plan.parts)).split(" ").join("");
        read.memory.u = read.memory.u.length > MOST_MADE ? "" : read.memory.u;
        remember(comp, read.tag, read.memory);
    }

    function layersOnly(parts) {
        var found = [];
        for (var i = 0; i < parts.length; i++) {
            if (parts[i].kind === "layer") {
                found.push(parts[i]);
            }
        }
        return found;
    }

    /**
     * A layer whose matte is the one right above cannot be moved without it.
     * @param {Entry[]} ours
     */
    function reorder(ours) {
        var i;
        for (i = 0; i < ours.length; i++) {
            if (withMatte(ours[i].layer) !== ours[i].layer) {
                return false;
            }
        }
        for (i = 1; i < ours.length; i++) {
            if (ours[i].layer.index > ours[i - 1].layer.index) {
                moveOver(ours[i].layer, ours[i - 1].layer);
            }
        }
        return true;
    }

    function moveOver(layer, lower) {
        unlocked(layer, function () {
            layer.moveBefore(lower);
        });
    }
