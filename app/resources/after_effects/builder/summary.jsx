    /* What was done, what was left and why: said once, at the end. */
    var MOST_LINES = 12;
    var changes = {};
    var leaves = {};
    var changedNames = [];
    var leftNames = [];
    var addedNames = [];
    var foreignNames = [];
    var deletedNames = [];
    var goneNames = [];
    var backNames = [];
    var notes = [];
    var mainName = null;
    var isFirstTime = true;

    function nameOfEntry(entry) {
        return entry.comp.name === mainName ? entry.layer.name : entry.comp.name + " / " + entry.layer.name;
    }

    function tellChanged(name, aspect) {
        tell(changes, changedNames, name, WORDS.aspects[aspect]);
    }

    function tellLeft(name, aspect) {
        tell(leaves, leftNames, name, WORDS.aspects[aspect]);
    }

    function tell(words, names, name, aspect) {
        if (!words["$" + name]) {
            words["$" + name] = [];
            names.push(name);
        }
        if ((", " + words["$" + name].join(", ") + ",").indexOf(", " + aspect + ",") < 0) {
            words["$" + name].push(aspect);
        }
    }

    function tellNote(words) {
        if (("\n" + notes.join("\n") + "\n").indexOf("\n" + words + "\n") < 0) {
            notes.push(words);
        }
    }

    function linesOf(words, names) {
        var lines = [];
        for (var i = 0; i < names.length; i++) {
            lines.push(names[i] + ": " + words["$" + names[i]].join(", "));
        }
        return lines;
    }

    function addPart(parts, head, lines) {
        if (lines.length === 0) {
            return;
        }
        var shown = lines.slice(0, MOST_LINES);
        if (lines.length > MOST_LINES) {
            shown.push(said(WORDS.more, [lines.length - MOST_LINES]));
        }
        parts.push(head + "\n" + shown.join("\n"));
    }

    /* The first time only what is to be known; the panel is silent where nothing had to be left. */
    function report(target) {
        var parts = [];
        addPart(parts, WORDS.left, linesOf(leaves, leftNames));
        addPart(parts, WORDS.foreign, foreignNames);
        addPart(parts, WORDS.deleted, deletedNames);
        addPart(parts, WORDS.gone, goneNames);
        addPart(parts, WORDS.notes, notes);
        var isSilent = parts.length === 0 && (isFirstTime || target);
        if (isSilent) {
            return;
        }
        var done = [];
        if (!isFirstTime) {
            addPart(done, WORDS.changed, linesOf(changes, changedNames));
            addPart(done, WORDS.added, addedNames);
            addPart(done, WORDS.back, backNames);
            var isChanged = done.length + goneNames.length > 0;
            done.unshift(said(isChanged ? WORDS.updated : WORDS.unchanged, [title]));
        }
        alert(done.concat(parts).join("\n\n"));
    }
