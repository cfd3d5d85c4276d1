    /* The layers of nested compositions have tags of their own: the same shadow may have lain in the main one before. */
    function scoped(wanted, tag) {
        return coded((wanted.tag === "main" ? "" : "in:" + wanted.tag + ":") + tag);
    }

    /* In the panel characters and background are the user's own layers. */
    function isNeeded(tag, target) {
        return !target || !/^(background$|cels:)/.test(tag);
    }

    /* What stands in a composition of the hand-off, from the bottom up. */
    function partsOf(wanted, target) {
        var parts = [];
        var i;
        if (wanted.white) {
            parts.push({ tag: scoped(wanted, "white"), wanted: null, kind: "white", name: "White" });
        }
        for (i = 0; i < wanted.layers.length; i++) {
            if (isNeeded(wanted.layers[i].tag, target)) {
                parts.push({ tag: scoped(wanted, wanted.layers[i].tag), wanted: wanted.layers[i], kind: "layer", name: wanted.layers[i].name });
            }
        }
        for (i = 0; i < wanted.nulls.length; i++) {
            parts.push({ tag: scoped(wanted, wanted.nulls[i].tag), wanted: wanted.nulls[i], kind: "null", name: wanted.nulls[i].name });
        }
        if (wanted.tag === "main") {
            parts.push({ tag: "controls", wanted: null, kind: "controls", name: "Kagezou" });
        }
        return parts;
    }

    function isAnywhere(parts) {
        for (var i = 0; i < parts.length; i++) {
            if (entriesOf(parts[i].tag).length > 0) {
                return true;
            }
        }
        return false;
    }

    /* Without a ledger, as of older versions, what has footage was made before. */
    function wasMade(tag, footage) {
        return made["$" + signsOf(tag)] === true || (!hasLedger && itemsOf("comp:main").length > 0 && (footage === null || itemsOfFootage(footage).length > 0));
    }

    function isReturning() {
        try {
            return ScriptUI.environment.keyboardState.shiftKey === true;
        } catch (problem) {
            return false;
        }
    }

    /* What each composition of the hand-off is to become: built, brought up to date, or left deleted; and which of its
       parts are added, which are those that were never there. */
    function planOf(target) {
        var plans = [];
        var returning = isReturning();
        for (var i = HAND_OFF.comps.length - 1; i >= 0; i--) {
            var wanted = HAND_OFF.comps[i];
            var isMain = i === HAND_OFF.comps.length - 1;
            if (target && !isMain && wanted.tag.indexOf("united:") !== 0) {
                continue;
            }
            var parts = partsOf(wanted, target);
            var tag = coded("comp:" + wanted.tag);
            var instances = target && isMain ? [target.comp] : itemsOf(tag);
            var isFresh = isMain && (target ? !holdsEntries(target.comp) : instances.length === 0 && (returning || !isAnywhere(parts)));
            var isBuilt = instances.length === 0 && (isFresh || returning || (!isMain && (plans[0].isFresh || !wasMade(tag, null))));
            var plan = { wanted: wanted, parts: parts, instances: instances, isFresh: isFresh || isBuilt, isBuilt: isBuilt, isTarget: Boolean(target) && isMain, added: {} };
            for (var j = 0; j < parts.length; j++) {
                var isThere = entriesOf(parts[j].tag).length > 0;
                var footage = parts[j].kind === "layer" ? parts[j].wanted.footage : null;
                var isOffered = parts[j].kind !== "controls" || HAND_OFF.controls;
                plan.added["$" + parts[j].tag] = isOffered && (plan.isFresh || (!isThere && (returning || !wasMade(parts[j].tag, footage))));
            }
            plans.push(plan);
        }
        return plans.reverse();
    }

    function holdsEntries(comp) {
        var all = [comp].concat(within(comp, []));
        for (var i = 0; i < all.length; i++) {
            if (entriesIn(all[i]).length > 0) {
                return true;
            }
        }
        return false;
    }
