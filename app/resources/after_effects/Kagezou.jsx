/* The Kagezou panel for After Effects. Put this file into Scripts/ScriptUI Panels and open it from the Window menu.
   It makes a Kagezou project of the selected layers, timed as they are, opens it, and brings the shadows back into the
   same composition, whose comment says which project is its own. */
(function (host) {
    var ja = String(app.isoLanguage).indexOf("ja") === 0;
    var WORDS = {
        make: ja ? "\u9078\u629e\u30ec\u30a4\u30e4\u30fc\u304b\u3089\u4f5c\u6210" : "Make from Selected Layers",
        open: ja ? "Kagezou \u3067\u958b\u304f" : "Open in Kagezou",
        bring: ja ? "\u5f71\u3092\u8aad\u307f\u8fbc\u3080" : "Bring Shadows Back",
        program: ja ? "\u30d7\u30ed\u30b0\u30e9\u30e0..." : "Program...",
        choose: ja ? "kagezou \u306e\u5834\u6240\u3092\u9078\u3093\u3067\u304f\u3060\u3055\u3044" : "Where is the program kagezou?",
        save: ja ? "Kagezou \u30d7\u30ed\u30b8\u30a7\u30af\u30c8\u306e\u4fdd\u5b58\u5148" : "Save the Kagezou project as",
        noComp: ja ? "\u30b3\u30f3\u30dd\u30b8\u30b7\u30e7\u30f3\u3067\u30ad\u30e3\u30e9\u30af\u30bf\u30fc\u306e\u30ec\u30a4\u30e4\u30fc\u3092\u9078\u629e\u3057\u3066\u304f\u3060\u3055\u3044\u3002" : "Select the layers of the characters in a composition.",
        noFile: ja ? "\u30d5\u30a1\u30a4\u30eb\u306e\u306a\u3044\u30ec\u30a4\u30e4\u30fc\u3067\u3059: " : "This layer shows no file: ",
        which: ja ? "\u3053\u306e\u30b3\u30f3\u30dd\u30b8\u30b7\u30e7\u30f3\u306e Kagezou \u30d7\u30ed\u30b8\u30a7\u30af\u30c8\u3092\u9078\u3093\u3067\u304f\u3060\u3055\u3044" : "Which Kagezou project belongs to this composition?",
        openComp: ja ? "\u30b3\u30f3\u30dd\u30b8\u30b7\u30e7\u30f3\u3092\u958b\u3044\u3066\u304f\u3060\u3055\u3044\u3002" : "Open a composition.",
        below: ja ? "\u5f71\u3092\u6577\u304f\u30ad\u30e3\u30e9\u30af\u30bf\u30fc\u306e\u30ec\u30a4\u30e4\u30fc\u3092\u9078\u629e\u3057\u3066\u304f\u3060\u3055\u3044\u3002" : "Select the layers of the characters under which the shadows are to lie.",
        there: ja ? "\u3059\u3067\u306b\u3042\u308a\u307e\u3059\u3002\u7f6e\u304d\u63db\u3048\u307e\u3059\u304b\uff1f\n" : "It is there already. Replace it?\n",
        moved: ja ? "\u6b21\u306e\u30ec\u30a4\u30e4\u30fc\u306f\u79fb\u52d5\u30fb\u62e1\u5927\u7e2e\u5c0f\u30fb\u56de\u8ee2\u3055\u308c\u3066\u3044\u307e\u3059\u3002Kagezou \u3067\u306f\u4e2d\u592e\u306b\u539f\u5bf8\u3067\u7f6e\u304b\u308c\u307e\u3059:\n" : "These layers are moved, scaled or turned; Kagezou takes them in the middle at their own size:\n",
        badName: ja ? "\u3053\u306e\u540d\u524d\u306f\u6e21\u305b\u307e\u305b\u3093: " : "This name cannot be handed over: ",
        failed: ja ? "Kagezou \u304c\u5931\u6557\u3057\u307e\u3057\u305f:\n" : "Kagezou failed:\n",
        allow: ja ? "\u74b0\u5883\u8a2d\u5b9a > \u30b9\u30af\u30ea\u30d7\u30c8\u3068\u30a8\u30af\u30b9\u30d7\u30ec\u30c3\u30b7\u30e7\u30f3\u3067\u3001\u30d5\u30a1\u30a4\u30eb\u3078\u306e\u66f8\u304d\u8fbc\u307f\u3092\u8a31\u53ef\u3057\u3066\u304f\u3060\u3055\u3044\u3002" : "In Preferences > Scripting & Expressions, allow scripts to write files."
    };
    var SECTION = "Kagezou";
    var isWindows = $.os.indexOf("Windows") === 0;

    function setting(name, fallback) {
        return app.settings.haveSetting(SECTION, name) ? app.settings.getSetting(SECTION, name) : fallback;
    }

    /* An argument that the system's command line takes as one word, whatever is in it. */
    function quoted(text) {
        if (isWindows) {
            if (/["%\r\n]/.test(text)) {
                throw new Error(WORDS.badName + text);
            }
            return "\"" + text.replace(/\\+$/, function (tail) { return tail + tail; }) + "\"";
        }
        if (/[\r\n]/.test(text)) {
            throw new Error(WORDS.badName + text);
        }
        return "'" + text.replace(/'/g, "'\\''") + "'";
    }

    function commandOf(words) {
        var made = [quoted(setting("program", "kagezou"))];
        for (var i = 0; i < words.length; i++) {
            made.push(quoted(words[i]));
        }
        return made.join(" ");
    }

    function call(line) {
        try {
            return system.callSystem(line);
        } catch (problem) {
            throw new Error(WORDS.allow + "\n" + (problem.message || problem));
        }
    }

    /* Runs to its end; its last line tells whether it went well, for callSystem gives no exit code. */
    function run(words) {
        var line = commandOf(words);
        var whole = isWindows ? "cmd.exe /c \"" + line + " 2>&1 && echo kagezou-done\"" : line + " 2>&1 && echo kagezou-done";
        var said = call(whole);
        if (said.indexOf("kagezou-done") < 0) {
            throw new Error(WORDS.failed + said);
        }
    }

    function start(words) {
        var line = commandOf(words);
        call(isWindows ? "cmd.exe /c start \"\" " + line : line + " >/dev/null 2>&1 &");
    }

    function activeComp() {
        var comp = app.project ? app.project.activeItem : null;
        if (!(comp instanceof CompItem)) {
            throw new Error(WORDS.openComp);
        }
        return comp;
    }

    /* A File takes what looks like an escape of a URI for one. */
    function fileAt(path) {
        return new File(path.replace(/%(?=[0-9a-fA-F]{2})/g, "%25"));
    }

    function lowest(comp) {
        var found = null;
        for (var i = 0; i < comp.selectedLayers.length; i++) {
            if (found === null || comp.selectedLayers[i].index > found.index) {
                found = comp.selectedLayers[i];
            }
        }
        return found;
    }

    function sourceOf(layer) {
        var source = layer.source ? layer.source.mainSource : null;
        if (!source || !source.file) {
            throw new Error(WORDS.noFile + layer.name);
        }
        if (source.isStill) {
            return source.file.fsName;
        }
        /* Of a sequence its own files; the folder may hold others. */
        var parts = numbered(source.file);
        return source.file.parent.fsName + (parts && parts[1].indexOf("#") < 0 ? "/" + parts[1] + "#" + parts[3] : "");
    }

    function numbered(file) {
        return /^(.*?)(\d{1,6})(\.\w+)$/.exec(nameOf(file));
    }

    function nameOf(file) {
        return file.fsName.replace(/^.*[\/\\]/, "");
    }

    /* 23.976 is 24000/1001, whatever digits After Effects shows of it. */
    function rateOf(comp) {
        var whole = Math.round(comp.frameRate);
        return Math.abs(comp.frameRate - whole) < 0.0005 ? String(whole) : Math.round(comp.frameRate * 1.001) * 1000 + "/1001";
    }

    /* A name that a layer of Kagezou may have; "=" would end it on the command line. */
    function plainName(text) {
        return text.replace(/[=\x00-\x1f\x7f-\x9f\u2028\u2029]/g, "_").replace(/^\s+|\s+$/g, "").substring(0, 190) || "A";
    }

    /* Names of the layers from the bottom, no two alike. */
    function namesOf(layers) {
        var names = [];
        var taken = {};
        for (var i = 0; i < layers.length; i++) {
            var name = plainName(layers[i].name);
            for (var number = 2; taken["$" + name.toLowerCase()]; number++) {
                name = plainName(layers[i].name) + " " + number;
            }
            taken["$" + name.toLowerCase()] = true;
            names.push(name);
        }
        return names;
    }

    /* The drawing that a layer shows at a time as its sheet would call it, or the sign of an empty cel. */
    function celAt(layer, time) {
        if (time < layer.inPoint || time >= layer.outPoint) {
            return "SYMBOL_NULL_CELL";
        }
        var opacity = layer.property("ADBE Transform Group").property("ADBE Opacity");
        if (opacity.numKeys > 0 && opacity.valueAtTime(time, false) === 0) {
            return "SYMBOL_NULL_CELL";
        }
        var source = layer.source.mainSource;
        if (source.isStill) {
            return nameOf(source.file).replace(/\.[^.]*$/, "");
        }
        var shown = layer.timeRemapEnabled
            ? layer.property("ADBE Time Remapping").valueAtTime(time, false)
            : (time - layer.startTime) * 100 / layer.stretch;
        /* That to conform to is 0 where none was set. */
        var rate = source.displayFrameRate;
        var last = Math.round(layer.source.duration * rate) - 1;
        var parts = numbered(source.file);
        return String((parts ? Number(parts[2]) : 0) + Math.max(0, Math.min(last, Math.floor(shown * rate + 0.001))));
    }

    function textOf(text) {
        return "\"" + text.replace(/[\\"]/g, "\\$&") + "\"";
    }

    function columnOf(layer, comp, frames) {
        var rows = [];
        var before = null;
        for (var frame = 0; frame < frames; frame++) {
            /* A little into the frame, so that a key on it counts. */
            var cel = celAt(layer, (frame + 0.01) / comp.frameRate);
            if (cel !== before) {
                rows.push("{\"frame\":" + frame + ",\"data\":[{\"id\":0,\"values\":[" + textOf(cel) + "]}]}");
                before = cel;
            }
        }
        return rows.join(",");
    }

    /* The layers' timing as a timesheet in a file that only lives until the project is made. */
    function writeSheet(comp, layers, names) {
        var frames = Math.max(1, Math.round(comp.duration * comp.frameRate));
        var titles = [];
        var tracks = [];
        for (var i = 0; i < layers.length; i++) {
            titles.push(textOf(names[i]));
            tracks.push("{\"trackNo\":" + i + ",\"frames\":[" + columnOf(layers[i], comp, frames) + "]}");
        }
        var file = new File(Folder.temp.fsName + "/kagezou-" + new Date().getTime() + ".xdts");
        file.encoding = "UTF-8";
        if (!file.open("w")) {
            throw new Error(WORDS.allow);
        }
        file.write("exchangeDigitalTimeSheet Save Data\n{\"timeTables\":[{\"name\":\"\",\"duration\":" + frames
            + ",\"timeTableHeaders\":[{\"fieldId\":0,\"names\":[" + titles.join(",")
            + "]}],\"fields\":[{\"fieldId\":0,\"tracks\":[" + tracks.join(",") + "]}]}],\"version\":5}");
        file.close();
        return file;
    }

    function isMoved(layer, comp) {
        var transform = layer.property("ADBE Transform Group");
        var position = transform.property("ADBE Position");
        var scale = transform.property("ADBE Scale");
        var anchor = transform.property("ADBE Anchor Point").value;
        var turned = transform.property("ADBE Rotate Z");
        return position.numKeys + scale.numKeys + turned.numKeys > 0 || turned.value !== 0
            || Math.abs(scale.value[0] - 100) > 0.01 || Math.abs(scale.value[1] - 100) > 0.01
            || Math.abs(position.value[0] - anchor[0] - (comp.width - layer.source.width) / 2) > 0.51
            || Math.abs(position.value[1] - anchor[1] - (comp.height - layer.source.height) / 2) > 0.51;
    }

    function selectedFromBottom(comp) {
        var found = [];
        for (var i = comp.numLayers; i >= 1; i--) {
            if (comp.layer(i).selected) {
                found.push(comp.layer(i));
            }
        }
        return found;
    }

    function makeProject() {
        var comp = activeComp();
        var layers = selectedFromBottom(comp);
        if (layers.length === 0) {
            throw new Error(WORDS.noComp);
        }
        var names = namesOf(layers);
        var words = [];
        var moved = [];
        for (var i = 0; i < layers.length; i++) {
            words.push("--character", names[i] + "=" + sourceOf(layers[i]));
            if (isMoved(layers[i], comp)) {
                moved.push(layers[i].name);
            }
        }
        var file = File.saveDialog(WORDS.save, "Kagezou:*.kage");
        if (file === null) {
            return;
        }
        if (!/\.kage$/i.test(file.fsName)) {
            file = fileAt(file.fsName + ".kage");
            /* The dialog has asked about the name that was typed, not about this one. */
            if (file.exists && !confirm(WORDS.there + file.fsName)) {
                return;
            }
        }
        var sheet = writeSheet(comp, layers, names);
        try {
            run(["new", file.fsName, "--fps", rateOf(comp), "--size", comp.width + "x" + comp.height, "--force", "--timesheet", sheet.fsName].concat(words));
        } finally {
            sheet.remove();
        }
        noteProject(comp, file.fsName);
        if (moved.length > 0) {
            alert(WORDS.moved + moved.join("\n"));
        }
    }

    /* Each composition has its own project, named at the end of its comment. */
    function noteProject(comp, path) {
        app.beginUndoGroup("Kagezou");
        try {
            var own = comp.comment.replace(/\s?kagezou-project: .*$/, "");
            comp.comment = (own === "" ? "" : own + " ") + "kagezou-project: " + path;
        } finally {
            app.endUndoGroup();
        }
    }

    /* Returns null when nobody says which. */
    function projectOf(comp) {
        var found = /kagezou-project: (.*)$/.exec(comp.comment);
        if (found !== null && fileAt(found[1]).exists) {
            return found[1];
        }
        var file = /** @type {File} */ (File.openDialog(WORDS.which, "Kagezou:*.kage"));
        if (file === null) {
            return null;
        }
        noteProject(comp, file.fsName);
        return file.fsName;
    }

    function openProject() {
        var path = projectOf(activeComp());
        if (path !== null) {
            start([path]);
        }
    }

    /* Whether shadows of this project lie in the composition already, so that nobody has to say where. */
    function hasShadows(comp, path) {
        for (var i = 1; i <= comp.numLayers; i++) {
            if (comp.layer(i).comment.indexOf("kagezou:" + path + ":shadow:") === 0) {
                return true;
            }
        }
        return false;
    }

    function bringBack() {
        var comp = activeComp();
        var path = projectOf(comp);
        if (path === null) {
            return;
        }
        if (comp.selectedLayers.length === 0 && !hasShadows(comp, path)) {
            throw new Error(WORDS.below);
        }
        var folder = path.replace(/\.kage$/i, "") + "_ae";
        run(["export-ae", path, "-o", folder, "--name", "kagezou", "--footage", "reference", "--skip-existing"]);
        $.global.KAGEZOU_TARGET = { comp: comp, below: lowest(comp), project: path, name: nameOf(fileAt(path)).replace(/\.kage$/i, "") };
        try {
            $.evalFile(fileAt(folder + "/kagezou.jsx"));
        } finally {
            $.global.KAGEZOU_TARGET = null;
        }
    }

    function chooseProgram() {
        var file = /** @type {File} */ (File.openDialog(WORDS.choose));
        if (file !== null) {
            app.settings.saveSetting(SECTION, "program", file.fsName);
        }
    }

    function trying(work) {
        return function () {
            try {
                work();
            } catch (problem) {
                alert(problem.message || String(problem));
            }
        };
    }

    var panel = /** @type {Window} */ (host instanceof Panel ? host : new Window("palette", "Kagezou", undefined, { resizeable: true }));
    panel.orientation = "column";
    panel.alignChildren = ["fill", "top"];

    function addButton(words, work) {
        var button = panel.add("button", undefined, words);
        button.onClick = trying(work);
    }

    addButton(WORDS.make, makeProject);
    addButton(WORDS.open, openProject);
    addButton(WORDS.bring, bringBack);
    addButton(WORDS.program, chooseProgram);
    panel.onResizing = panel.onResize = function () { this.layout.resize(); };
    if (panel instanceof Window) {
        panel.center();
        panel.show();
    } else {
        host.layout.layout(true);
    }
}(this));
