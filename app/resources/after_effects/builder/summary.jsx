    /* What was done, what was left and why: said once, at the end. */
    /* So many lines a screen has room for, whatever there is to say. */
    var LINES_IN_ALL = 30;
    var LEAST_LINES = 3;
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
        if (lines.length > 0) {
            parts.push({ head: head, lines: lines });
        }
    }

    function shownOf(part, most) {
        var shown = part.lines.slice(0, most);
        if (part.lines.length > most) {
            shown.push(said(WORDS.more, [part.lines.length - most]));
        }
        return part.head + "\n" + shown.join("\n");
    }

    function textOf(title, parts) {
        var texts = title === "" ? [] : [title];
        var most = Math.max(LEAST_LINES, Math.floor(LINES_IN_ALL / Math.max(1, parts.length)));
        for (var i = 0; i < parts.length; i++) {
            texts.push(shownOf(parts[i], most));
        }
        return texts.join("\n\n");
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
        }
        var isChanged = done.length + goneNames.length > 0;
        var head = isFirstTime ? "" : said(isChanged ? WORDS.updated : WORDS.unchanged, [title]);
        alert(textOf(head, done.concat(parts)));
    }
