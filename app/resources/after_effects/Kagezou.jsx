/* The Kagezou panel for After Effects. Put this file into Scripts/ScriptUI Panels and open it from the Window menu.
   It makes a Kagezou project of the selected layers, timed and moved as they are, opens it, and brings the shadows back into the
   same composition, whose comment says which project is its own. Kagezou works beside After Effects, which waits for nothing. */
(function (host) {
    var ja = String(app.isoLanguage).indexOf("ja") === 0;
    var WORDS = {
        make: ja ? "\u9078\u629e\u30ec\u30a4\u30e4\u30fc\u304b\u3089\u4f5c\u6210" : "Make from Selected Layers",
        open: ja ? "Kagezou \u3067\u958b\u304f" : "Open in Kagezou",
        bring: ja ? "\u5f71\u3092\u8aad\u307f\u8fbc\u3080" : "Bring Shadows Back",
        missing: ja ? "\u898b\u3064\u304b\u3089\u306a\u3044\u30bb\u30eb" : "Missing drawings",
        fail: ja ? "\u8aad\u307f\u8fbc\u307e\u305a\u306b\u540d\u524d\u3092\u6319\u3052\u308b" : "Bring nothing, name them",
        empty: ja ? "\u30d5\u30ec\u30fc\u30e0\u3092\u7a7a\u306b\u3059\u308b" : "Leave the frames empty",
        hold: ja ? "\u8fd1\u304f\u306e\u30bb\u30eb\u3067\u57cb\u3081\u308b" : "Hold the nearest drawing",
        program: ja ? "\u30d7\u30ed\u30b0\u30e9\u30e0..." : "Program...",
        choose: ja ? "kagezou \u306e\u5834\u6240\u3092\u9078\u3093\u3067\u304f\u3060\u3055\u3044" : "Where is the program kagezou?",
        save: ja ? "Kagezou \u30d7\u30ed\u30b8\u30a7\u30af\u30c8\u306e\u4fdd\u5b58\u5148" : "Save the Kagezou project as",
        noComp: ja ? "\u30b3\u30f3\u30dd\u30b8\u30b7\u30e7\u30f3\u3067\u30ad\u30e3\u30e9\u30af\u30bf\u30fc\u306e\u30ec\u30a4\u30e4\u30fc\u3092\u9078\u629e\u3057\u3066\u304f\u3060\u3055\u3044\u3002" : "Select the layers of the characters in a composition.",
        noFile: ja ? "\u30d5\u30a1\u30a4\u30eb\u306e\u306a\u3044\u30ec\u30a4\u30e4\u30fc\u3067\u3059: " : "This layer shows no file: ",
        which: ja ? "\u3053\u306e\u30b3\u30f3\u30dd\u30b8\u30b7\u30e7\u30f3\u306e Kagezou \u30d7\u30ed\u30b8\u30a7\u30af\u30c8\u3092\u9078\u3093\u3067\u304f\u3060\u3055\u3044" : "Which Kagezou project belongs to this composition?",
        openComp: ja ? "\u30b3\u30f3\u30dd\u30b8\u30b7\u30e7\u30f3\u3092\u958b\u3044\u3066\u304f\u3060\u3055\u3044\u3002" : "Open a composition.",
        below: ja ? "\u5f71\u3092\u6577\u304f\u30ad\u30e3\u30e9\u30af\u30bf\u30fc\u306e\u30ec\u30a4\u30e4\u30fc\u3092\u9078\u629e\u3057\u3066\u304f\u3060\u3055\u3044\u3002" : "Select the layers of the characters under which the shadows are to lie.",
        there: ja ? "\u3059\u3067\u306b\u3042\u308a\u307e\u3059\u3002\u7f6e\u304d\u63db\u3048\u307e\u3059\u304b\uff1f\n" : "It is there already. Replace it?\n",
        left: ja ? "\u6b21\u306e\u3082\u306e\u306f Kagezou \u306b\u6e21\u3055\u308c\u307e\u305b\u3093\u3002Kagezou \u3067\u306f\u3053\u308c\u3089\u306a\u3057\u3067\u8868\u793a\u3055\u308c\u307e\u3059:\n" : "These are not handed over; Kagezou shows the layers without them:\n",
        threeD: ja ? "3D \u30ec\u30a4\u30e4\u30fc" : "3-D layer",
        mask: ja ? "\u30de\u30b9\u30af" : "mask",
        matte: ja ? "\u30c8\u30e9\u30c3\u30af\u30de\u30c3\u30c8" : "track matte",
        orient: ja ? "\u81ea\u52d5\u65b9\u5411" : "auto-orientation",
        skewed: ja ? "\u89aa\u30ec\u30a4\u30e4\u30fc\u306b\u3088\u308b\u6b6a\u307f" : "skew by the layers it is parented to",
        beyond: ja ? "\u7d20\u6750\u306e\u7bc4\u56f2\u5916\u306e\u30bf\u30a4\u30e0\u30ea\u30de\u30c3\u30d7" : "time remapping beyond its pictures",
        movie: ja ? "\u6b21\u306e\u30ec\u30a4\u30e4\u30fc\u306f\u30e0\u30fc\u30d3\u30fc\u3067\u3059\u3002\u30a2\u30eb\u30d5\u30a1\u4ed8\u304d\u306e\u9023\u756a\u753b\u50cf\u306b\u3057\u3066\u304b\u3089\u9078\u629e\u3057\u3066\u304f\u3060\u3055\u3044:\n" : "These layers show movies. Render them as numbered pictures with alpha, and select those:\n",
        psd: ja ? "\u6b21\u306e\u30ec\u30a4\u30e4\u30fc\u306f PSD \u30d5\u30a1\u30a4\u30eb\u5185\u306e 1 \u30ec\u30a4\u30e4\u30fc\u3067\u3059\u3002Kagezou \u3067 PSD \u30d5\u30a1\u30a4\u30eb\u3092\u76f4\u63a5\u958b\u304f\u304b\u3001\u9023\u756a\u753b\u50cf\u306b\u3057\u3066\u304f\u3060\u3055\u3044:\n" : "These show single layers of a PSD file. Open that file in Kagezou itself, or render them as numbered pictures:\n",
        within: ja ? "\u30d5\u30a1\u30a4\u30eb\u306e\u306a\u3044\u3082\u306e: " : "without a file: ",
        cropped: ja ? "\u30d7\u30ea\u30b3\u30f3\u30dd\u30fc\u30ba\u306e\u7aef\u3067\u5207\u308c\u308b\u90e8\u5206" : "what the edge of its precomposition cuts off",
        busy: ja ? "\u524d\u306e\u51e6\u7406\u304c\u307e\u3060\u7d42\u308f\u3063\u3066\u3044\u307e\u305b\u3093\u3002" : "Kagezou is still at work.",
        making: ja ? "\u30d7\u30ed\u30b8\u30a7\u30af\u30c8\u3092\u4f5c\u6210\u4e2d..." : "Making the project...",
        rendering: ja ? "\u5f71\u3092\u30ec\u30f3\u30c0\u30ea\u30f3\u30b0\u4e2d..." : "Rendering shadows...",
        reading: ja ? "\u5f71\u3092\u8aad\u307f\u8fbc\u307f\u4e2d..." : "Importing shadows...",
        cancel: ja ? "\u30ad\u30e3\u30f3\u30bb\u30eb" : "Cancel",
        stopping: ja ? "\u505c\u6b62\u3057\u3066\u3044\u307e\u3059..." : "Stopping...",
        stopped: ja ? "\u505c\u6b62\u3057\u307e\u3057\u305f\u3002" : "Stopped.",
        resumable: ja ? "\u505c\u6b62\u3057\u307e\u3057\u305f\u3002\u6b21\u56de\u306f\u7d9a\u304d\u304b\u3089\u59cb\u307e\u308a\u307e\u3059\u3002" : "Stopped. The next time goes on from there.",
        ready: ja ? "\u5b8c\u4e86" : "Done",
        notFound: ja ? "kagezou \u304c\u898b\u3064\u304b\u308a\u307e\u305b\u3093\u3002\u300c\u30d7\u30ed\u30b0\u30e9\u30e0...\u300d\u3067\u6307\u5b9a\u3057\u3066\u304f\u3060\u3055\u3044: " : "Kagezou is not found. Choose it with Program...: ",
        silent: ja ? "kagezou \u304b\u3089\u5fdc\u7b54\u304c\u3042\u308a\u307e\u305b\u3093\u3002\u30bf\u30fc\u30df\u30ca\u30eb\u3067\u300ckagezou doctor\u300d\u3092\u5b9f\u884c\u3057\u3066\u78ba\u8a8d\u3057\u3066\u304f\u3060\u3055\u3044\u3002" : "Kagezou does not answer. Run \u201ckagezou doctor\u201d in a terminal.",
        lost: ja ? "\u30b3\u30f3\u30dd\u30b8\u30b7\u30e7\u30f3\u304c\u3082\u3046\u3042\u308a\u307e\u305b\u3093\u3002" : "The composition is no longer there.",
        badName: ja ? "\u3053\u306e\u540d\u524d\u306f\u6e21\u305b\u307e\u305b\u3093: " : "This name cannot be handed over: ",
        failed: ja ? "Kagezou \u304c\u5931\u6557\u3057\u307e\u3057\u305f:\n" : "Kagezou failed:\n",
        allow: ja ? "\u74b0\u5883\u8a2d\u5b9a > \u30b9\u30af\u30ea\u30d7\u30c8\u3068\u30a8\u30af\u30b9\u30d7\u30ec\u30c3\u30b7\u30e7\u30f3\u3067\u3001\u30d5\u30a1\u30a4\u30eb\u3078\u306e\u66f8\u304d\u8fbc\u307f\u3092\u8a31\u53ef\u3057\u3066\u304f\u3060\u3055\u3044\u3002" : "In Preferences > Scripting & Expressions, allow scripts to write files."
    };
    var SECTION = "Kagezou";
    var isWindows = $.os.indexOf("Windows") === 0;

    /* The bytes of a text in UTF-8. */
    function bytesOf(text) {
        var bytes = [];
        var coded = encodeURIComponent(text);
        for (var i = 0; i < coded.length; i++) {
            if (coded.charAt(i) === "%") {
                bytes.push(parseInt(coded.substring(i + 1, i + 3), 16));
                i += 2;
            } else {
                bytes.push(coded.charCodeAt(i));
            }
        }
        return bytes;
    }

    /* Any text as a word of sh in ASCII alone, so that no encoding of the line matters. */
    function shellWord(text) {
        var bytes = bytesOf(text);
        var made = "";
        for (var i = 0; i < bytes.length; i++) {
            made += "\\0" + (bytes[i] + 512).toString(8).substring(1);
        }
        return "\"$(printf '%b' '" + made + "')\"";
    }

    /* PowerShell takes each of these quotes for the end of a text. */
    function powerWord(text) {
        return "'" + text.replace(/['\u2018\u2019\u201a\u201b]/g, "$&$&") + "'";
    }

    var DIGITS = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

    /* UTF-16 in base 64, which PowerShell takes for a whole script: any sign in ASCII, whatever the code page is. */
    function encodedCommand(text) {
        var bytes = [];
        for (var i = 0; i < text.length; i++) {
            bytes.push(text.charCodeAt(i) & 255, text.charCodeAt(i) >> 8);
        }
        var made = "";
        for (i = 0; i < bytes.length; i += 3) {
            var three = (bytes[i] << 16) | ((bytes[i + 1] || 0) << 8) | (bytes[i + 2] || 0);
            made += DIGITS.charAt(three >> 18) + DIGITS.charAt((three >> 12) & 63);
            made += i + 1 < bytes.length ? DIGITS.charAt((three >> 6) & 63) : "=";
            made += i + 2 < bytes.length ? DIGITS.charAt(three & 63) : "=";
        }
        return made;
    }

    /* Started apart, for callSystem waits for all who hold its pipe: on Windows by the shell, which hands nothing on, else
       with all streams elsewhere. The words lie in a file, so that only its name is on the line. */
    function start(words, isHidden) {
        var file = writeText("json", listText(words));
        var program = isHidden ? programPath() : windowProgram();
        var line = "P=" + shellWord(program) + "; A=" + shellWord("@" + file.fsName)
            + "; if command -v \"$P\" >/dev/null 2>&1; then (\"$P\" \"$A\" >/dev/null 2>&1 </dev/null &) else printf kagezou-failed; fi";
        if (isWindows) {
            var script = "try { Start-Process -FilePath " + powerWord(program) + " -ArgumentList " + powerWord("\"@" + file.fsName + "\"")
                + (isHidden ? " -WindowStyle Hidden" : "") + " -ErrorAction Stop } catch { [Console]::Out.Write('kagezou-failed') }";
            line = "powershell.exe -NoProfile -NonInteractive -WindowStyle Hidden -EncodedCommand " + encodedCommand(script);
        }
        if (call(line).indexOf("kagezou-failed") >= 0) {
            file.remove();
            throw new Error(WORDS.notFound + program);
        }
        return file;
    }

    /* The program that was chosen here, else the one that an installer says it has put somewhere, for this user or for all,
       else where people drag it on a Mac; what is not there any more is passed over, and the shell finds the rest. */
    function programPath() {
        if (app.settings.haveSetting(SECTION, "program")) {
            return app.settings.getSetting(SECTION, "program");
        }
        var told = [Folder.userData, Folder.appData];
        var places = [];
        for (var i = 0; i < told.length; i++) {
            var text = readText(fileAt(told[i].fsName + "/Kagezou/program.txt"));
            places.push(text === null ? "" : text.replace(/^\ufeff|\s+$/g, ""));
        }
        if (!isWindows) {
            places.push("/Applications/Kagezou.app/Contents/MacOS/kagezou");
        }
        for (i = 0; i < places.length; i++) {
            if (places[i] !== "" && fileAt(places[i]).exists) {
                return places[i];
            }
        }
        return "kagezou";
    }

    /* On Windows the program without a console, where it lies beside the other. */
    function windowProgram() {
        var program = programPath();
        var beside = program.replace(/kagezou\.exe$/i, "kagezou-window.exe");
        return isWindows && beside !== program && fileAt(beside).exists ? beside : program;
    }

    function call(line) {
        try {
            return system.callSystem(line);
        } catch (problem) {
            throw new Error(WORDS.allow + "\n" + (problem.message || problem));
        }
    }

    /* A text of JSON in ASCII. */
    function textOf(text) {
        return "\"" + text.replace(/[\\"\x00-\x1f\x7f-\uffff]/g, function (sign) {
            return "\\u" + ("000" + sign.charCodeAt(0).toString(16)).slice(-4);
        }) + "\"";
    }

    function listText(words) {
        var texts = [];
        for (var i = 0; i < words.length; i++) {
            texts.push(textOf(words[i]));
        }
        return "[" + texts.join(",\n") + "]";
    }

    /* Kagezou at work: what it is told to do, the files that go when it is over, and what follows then. */
    var job = null;
    var POLL_MS = 250;
    var MOST_STARTING_MS = 60000;
    var MOST_SILENT_MS = 120000;

    function now() {
        return new Date().getTime();
    }

    /* Whoever presses a button while Kagezou is at work is asked nothing. */
    function beIdle() {
        if (job !== null) {
            throw new Error(WORDS.busy);
        }
    }

    function begin(words, doing, files, then) {
        var told = tempFile("progress");
        var started = start(words.concat(["--progress-file", told.fsName]), true);
        job = { doing: doing, told: told, stop: fileAt(told.fsName + ".stop"), files: files.concat([started]), then: then, beat: "", heard: now(), isStarted: false, isStopping: false, task: 0 };
        showJob(doing, 0);
        job.task = app.scheduleTask("$.global." + handle + ".poll()", POLL_MS, true);
    }

    /* What Kagezou has written about its work, null where there is nothing yet. */
    function readTold() {
        var text = readText(job.told);
        if (text === null || text.indexOf("state: ") !== 0) {
            return null;
        }
        var told = { state: "", done: "0", total: "0", beat: "", said: [] };
        var lines = text.split(/[\r\n]+/);
        for (var i = 0; i < lines.length; i++) {
            var parts = /^(\w+): (.*)$/.exec(lines[i]);
            if (parts !== null && parts[1] === "said") {
                told.said.push(parts[2].replace(/^kagezou: (note: )?/, ""));
            } else if (parts !== null) {
                told[parts[1]] = parts[2];
            }
        }
        return told;
    }

    function poll() {
        if (job === null) {
            return;
        }
        var told = readTold();
        if (told === null || told.state === "running") {
            wait(told);
            return;
        }
        var over = job;
        endJob(told.state === "done" ? WORDS.ready : (told.state === "stopped" ? (over.doing === WORDS.rendering ? WORDS.resumable : WORDS.stopped) : ""));
        if (told.state === "done") {
            trying(function () {
                over.then(told.said);
            })();
        } else if (told.state === "failed") {
            alert(WORDS.failed + told.said.join("\n"));
        }
    }

    function wait(told) {
        var isNew = told !== null && told.beat + told.done !== job.beat;
        if (isNew) {
            job.isStarted = true;
            job.heard = now();
            job.beat = told.beat + told.done;
        }
        if (now() - job.heard > (job.isStarted ? MOST_SILENT_MS : MOST_STARTING_MS)) {
            endJob("");
            alert(WORDS.silent);
            return;
        }
        if (job.isStopping && told !== null && !job.stop.exists) {
            writeTo(job.stop, "");
        }
        if (told !== null) {
            var part = Number(told.total) > 0 ? Number(told.done) / Number(told.total) : 0;
            var count = Number(told.total) > 0 ? " " + told.done + " / " + told.total : "";
            showJob(job.isStopping ? WORDS.stopping : job.doing + count, part);
        }
    }

    function stopJob() {
        if (job !== null) {
            job.isStopping = true;
            writeTo(job.stop, "");
            status.text = WORDS.stopping;
        }
    }

    function endJob(words) {
        app.cancelTask(job.task);
        var files = job.files.concat([job.told, job.stop]);
        job = null;
        for (var i = 0; i < files.length; i++) {
            if (files[i].exists) {
                files[i].remove();
            }
        }
        showJob(words, 0);
    }

    function showJob(words, part) {
        for (var i = 0; i < buttons.length; i++) {
            buttons[i].enabled = job === null;
        }
        stopButton.enabled = job !== null;
        bar.value = Math.round(part * 100);
        status.text = words;
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

    /* What a layer shows, from the lowest: itself, or where it is a composition each layer within that shows a file. Each is
       the way to it: the layer of the composition, the one in that, and so on. ``without`` gets names of what shows none. */
    function leavesOf(layer, above, without) {
        var way = above.concat([layer]);
        var source = layer.source;
        if (source instanceof CompItem) {
            var leaves = [];
            for (var i = source.numLayers; i >= 1; i--) {
                var inner = /** @type {AVLayer} */ (source.layer(i));
                if (isSeen(inner)) {
                    leaves = leaves.concat(leavesOf(inner, way, without));
                }
            }
            return leaves;
        }
        if (!source || !source.mainSource || !source.mainSource.file) {
            without.push(layer.name);
            return [];
        }
        return [way];
    }

    /* Lights, cameras, nulls and guides show nothing of their own, nor do layers that are off. */
    /** @param {any} layer */
    function isSeen(layer) {
        var isOfPictures = layer.source || layer.matchName === "ADBE Text Layer" || layer.matchName === "ADBE Vector Layer";
        return Boolean(isOfPictures) && layer.hasVideo !== false && layer.enabled && !layer.nullLayer && !layer.guideLayer && !layer.adjustmentLayer;
    }

    function leafOf(way) {
        return way[way.length - 1];
    }

    /* A movie has no drawings of its own. */
    function isMovie(layer) {
        var source = layer.source.mainSource;
        var isFilm = /\.(mov|mp4|m4v|avi|mxf|mpe?g|m2ts?|mts|wmv|webm|mkv|gif|flv|3gp|dv|r3d|braw|ari|crm)$/i;
        return !source.isStill && (isFilm.test(nameOf(source.file)) || numbered(source.file) === null);
    }

    /* After Effects calls such an item by the layer, a stroke and the file. */
    function isLayerOfPsd(layer) {
        return /\.ps[db]$/i.test(nameOf(layer.source.mainSource.file)) && layer.source.name.indexOf("/") > 0;
    }

    function sourceOf(layer) {
        var source = layer.source.mainSource;
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

    /* 23.976 is 24000/1001, whatever digits After Effects shows of it; 12.5 is 12.5. */
    function rateOf(comp) {
        var whole = Math.round(comp.frameRate);
        if (Math.abs(comp.frameRate - whole) < 0.0005) {
            return String(whole);
        }
        var above = Math.round(comp.frameRate * 1.001);
        return Math.abs(above / 1.001 - comp.frameRate) < 0.0015 ? above * 1000 + "/1001" : String(Math.round(comp.frameRate * 10000) / 10000);
    }

    /* A name that a layer of Kagezou may have; "=" would end it on the command line. */
    function plainName(text) {
        return text.replace(/[=\x00-\x1f\x7f-\x9f\u2028\u2029]/g, "_").replace(/^\s+|\s+$/g, "").substring(0, 190) || "A";
    }

    /* A name like one that is wanted and unlike all before. */
    function freeName(wanted, taken) {
        var name = plainName(wanted);
        for (var number = 2; taken["$" + name.toLowerCase()]; number++) {
            name = plainName(wanted) + " " + number;
        }
        taken["$" + name.toLowerCase()] = true;
        return name;
    }

    /* The time within each composition on the way to a leaf, and behind them that of its pictures. */
    function timesOn(way, time) {
        var times = [time];
        for (var i = 0; i < way.length; i++) {
            var layer = way[i];
            times.push(layer.timeRemapEnabled
                ? layer.property("ADBE Time Remapping").valueAtTime(times[i], false)
                : (times[i] - layer.startTime) * 100 / layer.stretch);
        }
        return times;
    }

    function isShownAt(way, times) {
        for (var i = 0; i < way.length; i++) {
            var opacity = way[i].property("ADBE Transform Group").property("ADBE Opacity");
            /* One that runs backward ends before it begins. */
            var first = Math.min(way[i].inPoint, way[i].outPoint);
            var last = Math.max(way[i].inPoint, way[i].outPoint);
            if (times[i] < first || times[i] >= last || (opacity.numKeys > 0 && opacity.valueAtTime(times[i], false) === 0)) {
                return false;
            }
        }
        return true;
    }

    /* The drawing that a leaf shows at a time as its sheet would call it, or the sign of an empty cel. */
    function celAt(way, time) {
        var times = timesOn(way, time);
        if (!isShownAt(way, times)) {
            return "SYMBOL_NULL_CELL";
        }
        var footage = leafOf(way).source;
        var source = footage.mainSource;
        if (source.isStill) {
            return nameOf(source.file).replace(/\.[^.]*$/, "");
        }
        /* That to conform to is 0 where none was set. */
        var rate = source.displayFrameRate;
        var last = Math.round(footage.duration * rate) - 1;
        var parts = numbered(source.file);
        return String((parts ? Number(parts[2]) : 0) + Math.max(0, Math.min(last, Math.floor(times[way.length] * rate + 0.001))));
    }

    function columnOf(way, comp, frames) {
        var rows = [];
        var before = null;
        for (var frame = 0; frame < frames; frame++) {
            /* A little into the frame, so that a key on it counts. */
            var cel = celAt(way, (frame + 0.01) / comp.frameRate);
            if (cel !== before) {
                rows.push("{\"frame\":" + frame + ",\"data\":[{\"id\":0,\"values\":[" + textOf(cel) + "]}]}");
                before = cel;
            }
        }
        return rows.join(",");
    }

    /* The timing of cels as a timesheet in a file that only lives until the project is made. */
    function writeSheet(comp, cels) {
        var frames = framesOf(comp);
        var titles = [];
        var tracks = [];
        for (var i = 0; i < cels.length; i++) {
            titles.push(textOf(cels[i].name));
            tracks.push("{\"trackNo\":" + i + ",\"frames\":[" + columnOf(cels[i].way, comp, frames) + "]}");
        }
        return writeText("xdts", "exchangeDigitalTimeSheet Save Data\n{\"timeTables\":[{\"name\":\"\",\"duration\":" + frames
            + ",\"timeTableHeaders\":[{\"fieldId\":0,\"names\":[" + titles.join(",")
            + "]}],\"fields\":[{\"fieldId\":0,\"tracks\":[" + tracks.join(",") + "]}]}],\"version\":5}");
    }

    function framesOf(comp) {
        return Math.max(1, Math.round(comp.duration * comp.frameRate));
    }

    var made = 0;

    function tempFile(suffix) {
        made += 1;
        return fileAt(Folder.temp.fsName + "/kagezou-" + now() + "-" + made + "." + suffix);
    }

    function writeText(suffix, text) {
        var file = tempFile(suffix);
        writeTo(file, text);
        return file;
    }

    function writeTo(file, text) {
        file.encoding = "UTF-8";
        file.lineFeed = "Unix";
        if (!file.open("w")) {
            throw new Error(WORDS.allow);
        }
        file.write(text);
        file.close();
    }

    /* Null where it is not there, or is being replaced. */
    function readText(file) {
        file.encoding = "UTF-8";
        if (!file.exists || !file.open("r")) {
            return null;
        }
        var text = file.read();
        file.close();
        return text;
    }

    /* Effects that move pixels, by their match names. */
    var MOVING = "|ADBE Geometry2|ADBE Corner Pin|ADBE MESH WARP|ADBE BEZMESH|ADBE WRPMESH|ADBE Offset|ADBE Optics Compensation|ADBE Polar Coordinates|ADBE RESHAPE|ADBE LIQUIFY|ADBE Magnify|ADBE Mirror|ADBE Ripple|ADBE SCHMEAR|ADBE Spherize|ADBE Turbulent Displace|ADBE Displacement Map|ADBE Twirl|ADBE BULGE|ADBE Wave Warp|ADBE FreePin3|";

    /* How a flat layer lies at a time, in what it is parented to. */
    function lieAt(layer, time) {
        var transform = layer.property("ADBE Transform Group");
        var position = transform.property("ADBE Position");
        var place = position.dimensionsSeparated
            ? [transform.property("ADBE Position_0").valueAtTime(time, false), transform.property("ADBE Position_1").valueAtTime(time, false)]
            : position.valueAtTime(time, false);
        return {
            position: place,
            anchor: transform.property("ADBE Anchor Point").valueAtTime(time, false),
            scale: transform.property("ADBE Scale").valueAtTime(time, false),
            rotation: transform.property("ADBE Rotate Z").valueAtTime(time, false)
        };
    }

    /* [a, b, c, d, x, y]: x of the parent is a x + c y + x, y is b x + d y + y. */
    function matrixOf(lie) {
        var turn = lie.rotation * Math.PI / 180;
        var sx = lie.scale[0] / 100;
        var sy = lie.scale[1] / 100;
        var a = Math.cos(turn) * sx;
        var b = Math.sin(turn) * sx;
        var c = -Math.sin(turn) * sy;
        var d = Math.cos(turn) * sy;
        return [a, b, c, d, lie.position[0] - a * lie.anchor[0] - c * lie.anchor[1], lie.position[1] - b * lie.anchor[0] - d * lie.anchor[1]];
    }

    function placed(matrix, point) {
        return [matrix[0] * point[0] + matrix[2] * point[1] + matrix[4], matrix[1] * point[0] + matrix[3] * point[1] + matrix[5]];
    }

    /* All that moves a leaf from its own composition up to the outermost: what it is parented to, the layer that shows its
       composition, what that is parented to, and so on, each with the time there. */
    function moversOf(way, times) {
        var movers = [];
        for (var i = way.length - 1; i >= 0; i--) {
            if (i < way.length - 1) {
                movers.push({ layer: way[i], time: times[i] });
            }
            for (var parent = way[i].parent; parent !== null; parent = parent.parent) {
                movers.push({ layer: parent, time: times[i] });
            }
        }
        return movers;
    }

    /* How a leaf lies in the outermost composition at a time, as one move, turn and scale.
       What its movers skew is no such thing; then isSkewed tells. */
    function lieInComp(way, time, before) {
        var times = timesOn(way, time);
        var movers = moversOf(way, times);
        var lie = lieAt(leafOf(way), times[way.length - 1]);
        if (movers.length === 0) {
            return lie;
        }
        var mirrored = lie.scale[0] < 0;
        var linear = matrixOf(lie);
        var place = lie.position;
        for (var i = 0; i < movers.length; i++) {
            var above = lieAt(movers[i].layer, movers[i].time);
            var over = matrixOf(above);
            place = placed(over, place);
            linear = [
                over[0] * linear[0] + over[2] * linear[1], over[1] * linear[0] + over[3] * linear[1],
                over[0] * linear[2] + over[2] * linear[3], over[1] * linear[2] + over[3] * linear[3]
            ];
            mirrored = mirrored !== above.scale[0] < 0;
        }
        var side = mirrored ? -1 : 1;
        var width = Math.sqrt(linear[0] * linear[0] + linear[1] * linear[1]);
        var height = width > 0 ? (linear[0] * linear[3] - linear[1] * linear[2]) / width : 0;
        var turn = Math.atan2(side * linear[1], side * linear[0]) * 180 / Math.PI;
        if (before !== null) {
            turn += Math.round((before.rotation - turn) / 360) * 360;
        }
        return {
            position: place, anchor: lie.anchor, scale: [side * width * 100, side * height * 100], rotation: turn,
            isSkewed: Math.abs(linear[0] * linear[2] + linear[1] * linear[3]) > 0.001 * width * Math.abs(height)
        };
    }

    function liesOf(way, comp, frames) {
        var lies = [];
        for (var frame = 0; frame < frames; frame++) {
            lies.push(lieInComp(way, frame / comp.frameRate, frame > 0 ? lies[frame - 1] : null));
        }
        return lies;
    }

    /* Whether a layer lies otherwise than in the middle at its own size. */
    function isMoved(layer, comp, lies) {
        for (var i = 0; i < lies.length; i++) {
            var lie = lies[i];
            if (Math.abs(lie.rotation) > 0.000001 || Math.abs(lie.scale[0] - 100) > 0.01 || Math.abs(lie.scale[1] - 100) > 0.01
                || Math.abs(lie.position[0] - lie.anchor[0] - (comp.width - layer.source.width) / 2) > 0.51
                || Math.abs(lie.position[1] - lie.anchor[1] - (comp.height - layer.source.height) / 2) > 0.51) {
                return true;
            }
        }
        return false;
    }

    function numberText(value) {
        return String(Math.round(value * 1e6) / 1e6);
    }

    function valueText(value) {
        return typeof value === "number" ? numberText(value) : "[" + numberText(value[0]) + "," + numberText(value[1]) + "]";
    }

    /* A property over the composition as a project file has it: a value, or keys on the frames on which it changes. */
    function trackText(lies, name) {
        var texts = [];
        var keys = [];
        var i;
        for (i = 0; i < lies.length; i++) {
            texts.push(valueText(lies[i][name]));
        }
        for (i = 0; i < texts.length; i++) {
            var isHeld = i > 0 && i < texts.length - 1 && texts[i] === texts[i - 1] && texts[i] === texts[i + 1];
            if (!isHeld) {
                keys.push("{\"frame\":" + (i + 1) + ",\"value\":" + texts[i] + ",\"interpolation\":\"linear\"}");
            }
        }
        var isStill = keys.length <= 2 && texts[0] === texts[texts.length - 1];
        return isStill ? texts[0] : "{\"keys\":[" + keys.join(",") + "]}";
    }

    /* Where moved cels lie, as a file of values; null where none is moved. */
    function writeValues(comp, cels) {
        var frames = framesOf(comp);
        var rows = [];
        for (var i = 0; i < cels.length; i++) {
            var lies = isFlat(cels[i].way) ? liesOf(cels[i].way, comp, frames) : [];
            if (isMoved(leafOf(cels[i].way), comp, lies)) {
                var parts = ["position", "anchor", "scale", "rotation"];
                for (var j = 0; j < parts.length; j++) {
                    rows.push(textOf("layers." + cels[i].name + "." + parts[j]) + ":" + trackText(lies, parts[j]));
                }
            }
        }
        return rows.length > 0 ? writeText("json", "{" + rows.join(",\n") + "}") : null;
    }

    /* Whether all layers on a way, and all they are parented to, lie in the planes of their compositions. */
    function isFlat(way) {
        for (var i = 0; i < way.length; i++) {
            for (var each = way[i]; each !== null; each = each.parent) {
                if (each.threeDLayer) {
                    return false;
                }
            }
        }
        return true;
    }

    function noteOnce(list, words) {
        for (var i = 0; i < list.length; i++) {
            if (list[i] === words) {
                return;
            }
        }
        list.push(words);
    }

    /* What on the way to a leaf cannot be handed over, in words. */
    function leftOf(way, comp, left) {
        if (!isFlat(way)) {
            noteOnce(left, WORDS.threeD);
        } else if (isSkewed(liesOf(way, comp, framesOf(comp)))) {
            noteOnce(left, WORDS.skewed);
        }
        for (var i = 0; i < way.length; i++) {
            leftOfLayer(way[i], left);
        }
        if (isRemappedBeyond(way, comp)) {
            noteOnce(left, WORDS.beyond);
        }
        if (isFlat(way) && isCropped(way, comp)) {
            noteOnce(left, WORDS.cropped);
        }
    }

    function leftOfLayer(layer, left) {
        for (var each = layer; each !== null; each = each.parent) {
            if (each.autoOrient !== AutoOrientType.NO_AUTO_ORIENT) {
                noteOnce(left, WORDS.orient);
            }
        }
        if (layer.property("ADBE Mask Parade").numProperties > 0) {
            noteOnce(left, WORDS.mask);
        }
        if (layer.hasTrackMatte) {
            noteOnce(left, WORDS.matte);
        }
        var effects = layer.property("ADBE Effect Parade");
        for (var i = 1; i <= effects.numProperties; i++) {
            if (effects.property(i).enabled && MOVING.indexOf("|" + effects.property(i).matchName + "|") >= 0) {
                noteOnce(left, effects.property(i).name);
            }
        }
    }

    /* Whether a picture reaches beyond a composition that it lies in, and the edge of that is seen in the outermost; a picture
       that does so by its empty rim alone counts, too. */
    function isCropped(way, comp) {
        var frames = framesOf(comp);
        for (var inner = 1; inner < way.length; inner++) {
            for (var frame = 0; frame < frames; frame++) {
                var time = frame / comp.frameRate;
                var room = way[inner - 1].source;
                var shown = matrixOf(lieInComp(way.slice(inner), timesOn(way, time)[inner], null));
                var laid = inverted(matrixOf(lieInComp(way.slice(0, inner), time, null)));
                if (!isWithin(shown, leafOf(way).source, room) && (laid === null || !isWithin(laid, comp, room))) {
                    return true;
                }
            }
        }
        return false;
    }

    /* Whether a rectangle lies, all of it, within another after it is moved. */
    function isWithin(matrix, size, room) {
        for (var corner = 0; corner < 4; corner++) {
            var at = placed(matrix, [corner % 2 * size.width, corner < 2 ? 0 : size.height]);
            if (at[0] < -0.51 || at[1] < -0.51 || at[0] > room.width + 0.51 || at[1] > room.height + 0.51) {
                return false;
            }
        }
        return true;
    }

    /* Null for what makes everything flat. */
    function inverted(m) {
        var det = m[0] * m[3] - m[1] * m[2];
        return Math.abs(det) < 1e-9 ? null : [
            m[3] / det, -m[1] / det, -m[2] / det, m[0] / det,
            (m[2] * m[5] - m[3] * m[4]) / det, (m[1] * m[4] - m[0] * m[5]) / det
        ];
    }

    function isSkewed(lies) {
        for (var i = 0; i < lies.length; i++) {
            if (lies[i].isSkewed) {
                return true;
            }
        }
        return false;
    }

    function isRemappedBeyond(way, comp) {
        var frames = framesOf(comp);
        for (var frame = 0; frame < frames; frame++) {
            var times = timesOn(way, (frame + 0.01) / comp.frameRate);
            for (var i = 0; i < way.length; i++) {
                var isBeyond = times[i + 1] < -0.001 || times[i + 1] > way[i].source.duration + 0.001;
                if (way[i].timeRemapEnabled && isBeyond && isShownAt(way.slice(0, i + 1), times)) {
                    return true;
                }
            }
        }
        return false;
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

    /* Every cel of the layers, from the bottom: its name, the way to it, and the name of the figure that it is a part of where
       a composition has several. What cannot be handed over at all is refused by name. */
    function celsOf(layers) {
        var taken = {};
        var cels = [];
        var movies = [];
        var parts = [];
        var empty = [];
        var without = [];
        for (var i = 0; i < layers.length; i++) {
            var lacking = [];
            var ways = leavesOf(layers[i], [], lacking);
            var figure = freeName(layers[i].name, taken);
            if (ways.length === 0) {
                empty.push(layers[i].name);
            } else if (lacking.length > 0) {
                without.push(layers[i].name + ": " + WORDS.within + lacking.join(", "));
            }
            for (var j = 0; j < ways.length; j++) {
                if (isMovie(leafOf(ways[j]))) {
                    noteOnce(movies, wayName(ways[j]));
                } else if (isLayerOfPsd(leafOf(ways[j]))) {
                    noteOnce(parts, wayName(ways[j]));
                }
                var name = j === 0 ? figure : freeName(figure + " " + leafOf(ways[j]).name, taken);
                cels.push({ name: name, way: ways[j], figure: j === 0 ? null : figure });
            }
        }
        if (empty.length > 0) {
            throw new Error(WORDS.noFile + empty.join(", "));
        }
        if (movies.length > 0) {
            throw new Error(WORDS.movie + movies.join("\n"));
        }
        if (parts.length > 0) {
            throw new Error(WORDS.psd + parts.join("\n"));
        }
        return { cels: cels, without: without };
    }

    function wayName(way) {
        var names = [];
        for (var i = 0; i < way.length; i++) {
            names.push(way[i].name);
        }
        return names.join(" > ");
    }

    /* What of the layers is not handed over, a line each. */
    function leftWords(layers, cels, comp) {
        var lines = [];
        for (var i = 0; i < layers.length; i++) {
            var left = [];
            for (var j = 0; j < cels.length; j++) {
                if (cels[j].way[0] === layers[i]) {
                    leftOf(cels[j].way, comp, left);
                }
            }
            if (left.length > 0) {
                lines.push(layers[i].name + ": " + left.join(", "));
            }
        }
        return lines;
    }

    function askForProject() {
        var file = File.saveDialog(WORDS.save, "Kagezou:*.kage");
        if (file !== null && !/\.kage$/i.test(file.fsName)) {
            file = fileAt(file.fsName + ".kage");
            /* The dialog has asked about the name that was typed, not about this one. */
            if (file.exists && !confirm(WORDS.there + file.fsName)) {
                return null;
            }
        }
        return file;
    }

    function makeProject() {
        beIdle();
        var comp = activeComp();
        var layers = selectedFromBottom(comp);
        if (layers.length === 0) {
            throw new Error(WORDS.noComp);
        }
        var found = celsOf(layers);
        var left = found.without.concat(leftWords(layers, found.cels, comp));
        var file = askForProject();
        if (file === null) {
            return;
        }
        var words = [];
        for (var i = 0; i < found.cels.length; i++) {
            var cel = found.cels[i];
            var told = cel.name + "=" + sourceOf(leafOf(cel.way));
            words.push(cel.figure === null ? "--character" : "--cel", cel.figure === null ? told : cel.figure + "=" + told);
        }
        var files = [writeSheet(comp, found.cels)];
        words.push("--timesheet", files[0].fsName);
        var values = writeValues(comp, found.cels);
        if (values !== null) {
            files.push(values);
            words.push("--values", values.fsName);
        }
        begin(["new", file.fsName, "--fps", rateOf(comp), "--size", comp.width + "x" + comp.height, "--force"].concat(words), WORDS.making, files, function () {
            if (isThere(comp)) {
                noteProject(comp, file.fsName);
            }
            if (left.length > 0) {
                alert(WORDS.left + left.join("\n"));
            }
        });
    }

    /* What was removed throws at whatever is asked of it. */
    function isThere(object) {
        try {
            return typeof object.name === "string" && object.name.length >= 0;
        } catch (problem) {
            return false;
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

    var opened = null;

    function openProject() {
        var path = projectOf(activeComp());
        if (path !== null) {
            if (opened !== null && opened.exists) {
                opened.remove();
            }
            opened = start([path], false);
        }
    }

    /* Whether shadows of this project lie in the composition already, precomposed or not, so that nobody has to say where. */
    function hasShadows(comp, path) {
        for (var i = 1; i <= comp.numLayers; i++) {
            var source = comp.layer(i).source;
            if (comp.layer(i).comment.indexOf("kagezou:" + path + ":shadow:") >= 0 || (source instanceof CompItem && hasShadows(source, path))) {
                return true;
            }
        }
        return false;
    }

    function bringBack() {
        beIdle();
        var comp = activeComp();
        var path = projectOf(comp);
        if (path === null) {
            return;
        }
        if (comp.selectedLayers.length === 0 && !hasShadows(comp, path)) {
            throw new Error(WORDS.below);
        }
        var folder = path.replace(/\.kage$/i, "") + "_ae";
        var below = lowest(comp);
        var words = ["export-ae", path, "-o", folder, "--name", "kagezou", "--footage", "reference", "--skip-existing", "--missing", standingIn()];
        begin(words, WORDS.rendering, [], function (said) {
            if (!isThere(comp)) {
                throw new Error(WORDS.lost);
            }
            status.text = WORDS.reading;
            importInto(comp, below !== null && isThere(below) ? below : lowest(comp), path, folder);
            status.text = said.length > 0 ? said.join("\n") : WORDS.ready;
        });
    }

    /* What stands in for drawings that are not there, as --missing of the program has it: the one that was chosen last. */
    var WAYS = ["fail", "empty", "hold"];

    function standingIn() {
        var kept = app.settings.haveSetting(SECTION, "missing") ? app.settings.getSetting(SECTION, "missing") : "";
        for (var i = 0; i < WAYS.length; i++) {
            if (WAYS[i] === kept) {
                return kept;
            }
        }
        return WAYS[0];
    }

    function addStandingIn() {
        var row = panel.add("group");
        row.alignChildren = ["left", "center"];
        row.add("statictext", undefined, WORDS.missing);
        var list = row.add("dropdownlist", undefined, [WORDS.fail, WORDS.empty, WORDS.hold]);
        list.alignment = ["fill", "center"];
        for (var i = 0; i < WAYS.length; i++) {
            if (WAYS[i] === standingIn()) {
                list.selection = i;
            }
        }
        list.onChange = trying(function () {
            /* A number is only ever written to it. */
            var chosen = /** @type {ListItem | null} */ (list.selection);
            if (chosen !== null) {
                app.settings.saveSetting(SECTION, "missing", WAYS[chosen.index]);
            }
        });
    }

    function importInto(comp, below, path, folder) {
        $.global.KAGEZOU_TARGET = { comp: comp, below: below, project: path, name: nameOf(fileAt(path)).replace(/\.kage$/i, "") };
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

    var buttons = [];

    function addButton(words, work) {
        var button = panel.add("button", undefined, words);
        button.onClick = trying(work);
        return button;
    }

    buttons.push(addButton(WORDS.make, makeProject));
    buttons.push(addButton(WORDS.open, openProject));
    buttons.push(addButton(WORDS.bring, bringBack));
    addStandingIn();
    buttons.push(addButton(WORDS.program, chooseProgram));
    var bar = panel.add("progressbar", undefined, 0, 100);
    var status = panel.add("statictext", undefined, "", { multiline: true });
    status.preferredSize = [220, 48];
    var stopButton = addButton(WORDS.cancel, stopJob);
    stopButton.enabled = false;

    /* After Effects runs a scheduled text outside of this function. */
    var handle = "KAGEZOU_PANEL_" + now();
    $.global[handle] = { poll: poll };

    panel.onResizing = panel.onResize = function () { this.layout.resize(); };
    if (panel instanceof Window) {
        panel.center();
        panel.show();
    } else {
        host.layout.layout(true);
    }
}(this));
