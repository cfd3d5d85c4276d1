/* The Kagezou panel for After Effects. Put this file into Scripts/ScriptUI Panels and open it from the Window menu.
   It makes a Kagezou project of the selected layers, timed and moved as they are, opens it, and brings the shadows back into the
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
        left: ja ? "\u6b21\u306e\u3082\u306e\u306f Kagezou \u306b\u6e21\u3055\u308c\u307e\u305b\u3093\u3002Kagezou \u3067\u306f\u3053\u308c\u3089\u306a\u3057\u3067\u8868\u793a\u3055\u308c\u307e\u3059:\n" : "These are not handed over; Kagezou shows the layers without them:\n",
        threeD: ja ? "3D \u30ec\u30a4\u30e4\u30fc" : "3-D layer",
        mask: ja ? "\u30de\u30b9\u30af" : "mask",
        matte: ja ? "\u30c8\u30e9\u30c3\u30af\u30de\u30c3\u30c8" : "track matte",
        orient: ja ? "\u81ea\u52d5\u65b9\u5411" : "auto-orientation",
        skewed: ja ? "\u89aa\u30ec\u30a4\u30e4\u30fc\u306b\u3088\u308b\u6b6a\u307f" : "skew by the layers it is parented to",
        beyond: ja ? "\u7d20\u6750\u306e\u7bc4\u56f2\u5916\u306e\u30bf\u30a4\u30e0\u30ea\u30de\u30c3\u30d7" : "time remapping beyond its pictures",
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
        var frames = framesOf(comp);
        var titles = [];
        var tracks = [];
        for (var i = 0; i < layers.length; i++) {
            titles.push(textOf(names[i]));
            tracks.push("{\"trackNo\":" + i + ",\"frames\":[" + columnOf(layers[i], comp, frames) + "]}");
        }
        return writeText("xdts", "exchangeDigitalTimeSheet Save Data\n{\"timeTables\":[{\"name\":\"\",\"duration\":" + frames
            + ",\"timeTableHeaders\":[{\"fieldId\":0,\"names\":[" + titles.join(",")
            + "]}],\"fields\":[{\"fieldId\":0,\"tracks\":[" + tracks.join(",") + "]}]}],\"version\":5}");
    }

    function framesOf(comp) {
        return Math.max(1, Math.round(comp.duration * comp.frameRate));
    }

    function writeText(suffix, text) {
        var file = new File(Folder.temp.fsName + "/kagezou-" + new Date().getTime() + "." + suffix);
        file.encoding = "UTF-8";
        if (!file.open("w")) {
            throw new Error(WORDS.allow);
        }
        file.write(text);
        file.close();
        return file;
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

    /* How a layer lies in the composition at a time: with all it is parented to, as one move, turn and scale.
       What the layers it is parented to skew is no such thing; then isSkewed tells. */
    function lieInComp(layer, time, before) {
        var lie = lieAt(layer, time);
        if (layer.parent === null) {
            return lie;
        }
        var mirrored = lie.scale[0] < 0;
        var linear = matrixOf(lie);
        var place = lie.position;
        for (var parent = layer.parent; parent !== null; parent = parent.parent) {
            var above = lieAt(parent, time);
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

    function liesOf(layer, comp, frames) {
        var lies = [];
        for (var frame = 0; frame < frames; frame++) {
            lies.push(lieInComp(layer, frame / comp.frameRate, frame > 0 ? lies[frame - 1] : null));
        }
        return lies;
    }

    /* Whether a layer lies otherwise than in the middle at its own size. */
    function isMoved(layer, comp, lies) {
        for (var i = 0; i < lies.length; i++) {
            var lie = lies[i];
            if (lie.rotation !== 0 || Math.abs(lie.scale[0] - 100) > 0.01 || Math.abs(lie.scale[1] - 100) > 0.01
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

    /* Where moved layers lie, as a file of values; null where none is moved. */
    function writeValues(comp, layers, names) {
        var frames = framesOf(comp);
        var rows = [];
        for (var i = 0; i < layers.length; i++) {
            var lies = isFlat(layers[i]) ? liesOf(layers[i], comp, frames) : [];
            if (isMoved(layers[i], comp, lies)) {
                var parts = ["position", "anchor", "scale", "rotation"];
                for (var j = 0; j < parts.length; j++) {
                    rows.push(textOf("layers." + names[i] + "." + parts[j]) + ":" + trackText(lies, parts[j]));
                }
            }
        }
        return rows.length > 0 ? writeText("json", "{" + rows.join(",\n") + "}") : null;
    }

    /* Whether a layer and all it is parented to lie in the plane of the composition. */
    function isFlat(layer) {
        for (var each = layer; each !== null; each = each.parent) {
            if (each.threeDLayer) {
                return false;
            }
        }
        return true;
    }

    /* What of a layer cannot be handed over, in words. */
    function leftOf(layer, comp) {
        var left = [];
        var i;
        if (!isFlat(layer)) {
            left.push(WORDS.threeD);
        } else if (isSkewed(liesOf(layer, comp, framesOf(comp)))) {
            left.push(WORDS.skewed);
        }
        for (var each = layer; each !== null; each = each.parent) {
            if (each.autoOrient !== AutoOrientType.NO_AUTO_ORIENT && left.join().indexOf(WORDS.orient) < 0) {
                left.push(WORDS.orient);
            }
        }
        if (layer.property("ADBE Mask Parade").numProperties > 0) {
            left.push(WORDS.mask);
        }
        if (layer.hasTrackMatte) {
            left.push(WORDS.matte);
        }
        var effects = layer.property("ADBE Effect Parade");
        for (i = 1; i <= effects.numProperties; i++) {
            if (effects.property(i).enabled && MOVING.indexOf("|" + effects.property(i).matchName + "|") >= 0) {
                left.push(effects.property(i).name);
            }
        }
        if (isRemappedBeyond(layer, comp)) {
            left.push(WORDS.beyond);
        }
        return left;
    }

    function isSkewed(lies) {
        for (var i = 0; i < lies.length; i++) {
            if (lies[i].isSkewed) {
                return true;
            }
        }
        return false;
    }

    function isRemappedBeyond(layer, comp) {
        if (!layer.timeRemapEnabled) {
            return false;
        }
        var frames = framesOf(comp);
        for (var frame = 0; frame < frames; frame++) {
            var time = (frame + 0.01) / comp.frameRate;
            var shown = layer.property("ADBE Time Remapping").valueAtTime(time, false);
            if (time >= layer.inPoint && time < layer.outPoint && (shown < -0.001 || shown > layer.source.duration + 0.001)) {
                return true;
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

    function makeProject() {
        var comp = activeComp();
        var layers = selectedFromBottom(comp);
        if (layers.length === 0) {
            throw new Error(WORDS.noComp);
        }
        var names = namesOf(layers);
        var words = [];
        var left = [];
        for (var i = 0; i < layers.length; i++) {
            words.push("--character", names[i] + "=" + sourceOf(layers[i]));
            var lost = leftOf(layers[i], comp);
            if (lost.length > 0) {
                left.push(layers[i].name + ": " + lost.join(", "));
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
        var values = null;
        try {
            values = writeValues(comp, layers, names);
            if (values !== null) {
                words.push("--values", values.fsName);
            }
            run(["new", file.fsName, "--fps", rateOf(comp), "--size", comp.width + "x" + comp.height, "--force", "--timesheet", sheet.fsName].concat(words));
        } finally {
            sheet.remove();
            if (values !== null) {
                values.remove();
            }
        }
        noteProject(comp, file.fsName);
        if (left.length > 0) {
            alert(WORDS.left + left.join("\n"));
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
