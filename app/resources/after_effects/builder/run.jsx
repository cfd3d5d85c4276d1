    /* Before anything is changed: a file that is missing leaves the project as it is. */
    function checkFiles(plans, target) {
        for (var i = 0; i < HAND_OFF.footage.length; i++) {
            var footage = HAND_OFF.footage[i];
            if (isNeeded(footage.tag, target) && (itemsOfFootage(footage.tag).length > 0 || isToImport(footage.tag, plans))) {
                fileOf(footage);
            }
        }
    }

    function isToImport(tag, plans) {
        var wasThere = wasMade(coded("footage:" + tag), null) && !isReturning();
        return itemsOfFootage(tag).length === 0 && isWanted(tag, plans, wasThere);
    }

    function bringFootage(plans, root, target) {
        for (var i = 0; i < HAND_OFF.footage.length; i++) {
            var footage = HAND_OFF.footage[i];
            step();
            if (!isNeeded(footage.tag, target)) {
                continue;
            }
            var items = itemsOfFootage(footage.tag);
            if (isToImport(footage.tag, plans)) {
                importFootage(footage, root);
                noteMade(coded("footage:" + footage.tag));
            }
            for (var j = 0; j < items.length; j++) {
                updateFootage(/** @type {FootageItem} */ (items[j]), footage);
                noteMade(coded("footage:" + footage.tag));
            }
        }
    }

    /* Whether a layer of it is added, or, where no layer is of it, whether it was never there. */
    function isWanted(footage, plans, wasThere) {
        var isLaid = false;
        for (var i = 0; i < plans.length; i++) {
            for (var j = 0; j < plans[i].parts.length; j++) {
                var part = plans[i].parts[j];
                if (part.kind === "layer" && part.wanted.footage === footage) {
                    isLaid = true;
                    if (plans[i].added["$" + part.tag] && (plans[i].isBuilt || plans[i].instances.length > 0)) {
                        return true;
                    }
                }
            }
        }
        return !isLaid && !wasThere;
    }

    function updateParts(plans) {
        var wanted = {};
        var i;
        for (i = 0; i < plans.length; i++) {
            for (var j = 0; j < plans[i].parts.length; j++) {
                var part = plans[i].parts[j];
                wanted["$" + part.tag] = part;
                var isThere = entriesOf(part.tag).length > 0;
                var isAsked = part.kind !== "controls" || HAND_OFF.controls;
                if (!isThere && isAsked && (plans[i].isTarget || plans[i].instances.length > 0 || plans[i].wanted.tag === "main")) {
                    deletedNames.push(part.name);
                }
            }
        }
        for (i = 0; i < entries.length; i++) {
            updatePart(entries[i], wanted["$" + entries[i].tag]);
        }
    }

    function updatePart(entry, part) {
        unlocked(entry.layer, function () {
            if (!part) {
                switchOff(entry);
            } else if (part.kind === "layer") {
                updateLayer(entry, part.wanted);
            } else if (part.kind === "null") {
                updateNull(entry, part.wanted);
            }
        });
    }

    /* Two cuts may be called alike. Where a hand-off of this name came from a folder that is still there, the user says
       whether this one takes its place; one that lies beside it is known by its folder from then on. */
    function settleIdentity(target) {
        title = target ? target.name : HAND_OFF.name;
        if (target) {
            identity = target.project;
            indexItems();
            return;
        }
        var here = hereOf();
        identity = HAND_OFF.project + "@" + here;
        indexItems();
        if (itemsOf("root").length > 0) {
            return;
        }
        identity = HAND_OFF.project;
        indexItems();
        var elsewhere = shadowsElsewhere(here);
        if (elsewhere !== null && !confirm(WORDS.other + elsewhere + WORDS.replace)) {
            identity = HAND_OFF.project + "@" + here;
            indexItems();
        }
    }

    /* The folder of shadows that came from another folder than the script's, null where there are none. */
    function shadowsElsewhere(here) {
        var inside = slashed(here) + "/";
        for (var i = 0; i < HAND_OFF.footage.length; i++) {
            var items = HAND_OFF.footage[i].tag.indexOf("shadow:") === 0 ? itemsOfFootage(HAND_OFF.footage[i].tag) : [];
            var file = items.length === 0 ? null : /** @type {FootageItem} */ (items[0]).mainSource.file;
            if (file && file.exists) {
                return slashed(file.fsName).indexOf(inside) === 0 ? null : file.parent.fsName;
            }
        }
        return null;
    }

    function measure(plans) {
        var instances = [];
        var ours = [];
        var i;
        for (i = 0; i < HAND_OFF.footage.length; i++) {
            ours = ours.concat(itemsOfFootage(HAND_OFF.footage[i].tag));
        }
        for (i = 0; i < plans.length; i++) {
            instances = instances.concat(plans[i].instances);
            for (var j = 0; j < plans[i].instances.length; j++) {
                measureComp(plans[i].instances[j]);
            }
        }
        findFollowers(instances, ours.concat(instances));
        return instances;
    }

    function stepsOf() {
        var whole = HAND_OFF.footage.length;
        for (var i = 0; i < HAND_OFF.comps.length; i++) {
            whole += HAND_OFF.comps[i].layers.length;
        }
        return whole;
    }

    function tellOfMain(main, target, wasBuiltBefore) {
        var names = [];
        for (var i = 1; i < main.instances.length; i++) {
            names.push(main.instances[i].name);
        }
        if (names.length > 0) {
            tellNote(said(WORDS.copies, [names.join(", ")]));
        }
        if (wasBuiltBefore && main.isBuilt) {
            tellNote(said(WORDS.compAnew, [main.wanted.name]));
        }
        if (main.instances.length === 0 && !target) {
            tellNote(said(WORDS.compGone, [main.wanted.name]));
        }
    }

    function build(target) {
        settleIdentity(target);
        survey();
        readLedger();
        measureFootage();
        var plans = planOf(target);
        var main = plans[plans.length - 1];
        isFirstTime = main.isFresh;
        mainName = main.instances.length > 0 ? main.instances[0].name : main.wanted.name;
        var wasBuiltBefore = made["$" + signsOf("comp:main")] === true;
        var instances = measure(plans);
        if (!target) {
            askAbout(instances);
        }
        showProgress(stepsOf());
        checkFiles(plans, target);
        var root = folderOf(null, app.project.rootFolder);
        bringFootage(plans, root, target);
        for (var i = 0; i < plans.length; i++) {
            bringComp(plans[i], root, target);
        }
        if (main.instances.length > 0) {
            updateFollowers(main.instances[0]);
        }
        tellOfMain(main, target, wasBuiltBefore);
        updateParts(plans);
        checkProject();
        writeLedger();
        return main.instances.length > 0 ? main.instances[0] : null;
    }

    function bringComp(plan, root, target) {
        for (var i = 0; i < plan.instances.length; i++) {
            if (!plan.isTarget) {
                updateComp(plan.instances[i], false);
            }
        }
        if (plan.isBuilt) {
            plan.instances = [addComp(plan.wanted, root)];
        }
        if (plan.isTarget) {
            origins["$" + target.comp.id] = [Math.floor((target.comp.width - HAND_OFF.width) / 2), Math.floor((target.comp.height - HAND_OFF.height) / 2)];
        }
        for (i = 0; i < plan.instances.length; i++) {
            if (!plan.isTarget) {
                followOrder(plan, plan.instances[i]);
            }
            addParts(plan, plan.instances[i], root, target, i > 0);
            markComp(plan, plan.instances[i]);
        }
    }

    function markComp(plan, comp) {
        var read = plan.isTarget ? null : readComment(comp.comment);
        if (read === null) {
            return;
        }
        if (mark(comp.markerProperty, plan.wanted.markers, 0, read.memory)) {
            tellLeft(comp.name, "n");
        }
        remember(comp, read.tag, read.memory);
    }

    function start() {
        if (!$.fileName) {
            throw new Error(WORDS.save);
        }
        if (app.project === null) {
            app.newProject();
        }
        return build($.global.KAGEZOU_TARGET || null);
    }

    app.beginUndoGroup(WORDS.undo);
    try {
        var whole = start();
        if (whole !== null) {
            whole.openInViewer();
        }
        endProgress();
        report($.global.KAGEZOU_TARGET || null);
    } catch (problem) {
        endProgress();
        alert(WORDS.failed + (problem.message || problem));
    } finally {
        app.endUndoGroup();
    }
