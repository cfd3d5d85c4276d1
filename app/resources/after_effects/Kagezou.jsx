/* The Kagezou panel for After Effects. Put this file into Scripts/ScriptUI Panels and open it from the Window menu.
   It makes a Kagezou project of the selected layers, opens it, and brings the shadows back into the same composition. */
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
        noProject: ja ? "\u5148\u306b\u30d7\u30ed\u30b8\u30a7\u30af\u30c8\u3092\u4f5c\u6210\u3057\u3066\u304f\u3060\u3055\u3044\u3002" : "Make a project first.",
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

    /* Runs to its end; its last line tells whether it went well, for callSystem gives no exit code. */
    function run(words) {
        var line = commandOf(words);
        var whole = isWindows ? "cmd.exe /c \"" + line + " 2>&1 && echo kagezou-done\"" : line + " 2>&1 && echo kagezou-done";
        var said = system.callSystem(whole);
        if (said.indexOf("kagezou-done") < 0) {
            throw new Error(WORDS.failed + said);
        }
    }

    function start(words) {
        var line = commandOf(words);
        system.callSystem(isWindows ? "cmd.exe /c start \"\" " + line : line + " >/dev/null 2>&1 &");
    }

    function activeComp() {
        var comp = app.project ? app.project.activeItem : null;
        if (!(comp instanceof CompItem) || comp.selectedLayers.length === 0) {
            throw new Error(WORDS.noComp);
        }
        return comp;
    }

    function lowest(comp) {
        var found = comp.selectedLayers[0];
        for (var i = 1; i < comp.selectedLayers.length; i++) {
            if (comp.selectedLayers[i].index > found.index) {
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
        /* Of a sequence the whole folder, of a still the file. */
        return source.isStill ? source.file.fsName : source.file.parent.fsName;
    }

    /* 23.976 is 24000/1001, whatever digits After Effects shows of it. */
    function rateOf(comp) {
        var whole = Math.round(comp.frameRate);
        return Math.abs(comp.frameRate - whole) < 0.0005 ? String(whole) : Math.round(comp.frameRate * 1.001) * 1000 + "/1001";
    }

    function makeProject() {
        var comp = activeComp();
        var file = File.saveDialog(WORDS.save, "Kagezou:*.kage");
        if (file === null) {
            return;
        }
        if (!/\.kage$/i.test(file.fsName)) {
            file = new File(file.fsName + ".kage");
        }
        var words = ["new", file.fsName, "--fps", rateOf(comp), "--size", comp.width + "x" + comp.height, "--force"];
        /* From the bottom, as the layers lie. */
        for (var i = comp.numLayers; i >= 1; i--) {
            if (comp.layer(i).selected) {
                words.push("--character", comp.layer(i).name + "=" + sourceOf(comp.layer(i)));
            }
        }
        run(words);
        app.settings.saveSetting(SECTION, "project", file.fsName);
    }

    function project() {
        var path = setting("project", "");
        if (path === "" || !new File(path).exists) {
            throw new Error(WORDS.noProject);
        }
        return path;
    }

    function bringBack() {
        var comp = activeComp();
        var path = project();
        var name = new File(path).displayName.replace(/\.kage$/i, "");
        var folder = path.replace(/\.kage$/i, "") + "_ae";
        run(["export-ae", path, "-o", folder, "--name", "kagezou", "--footage", "reference", "--skip-existing"]);
        $.global.KAGEZOU_TARGET = { comp: comp, below: lowest(comp), name: name };
        try {
            $.evalFile(new File(folder + "/kagezou.jsx"));
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
    addButton(WORDS.open, function () { start([project()]); });
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
