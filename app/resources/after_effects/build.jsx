/* Made by Kagezou. File > Scripts > Run Script File... builds the composition, or brings it up to date.
   It needs After Effects CC 2018 or newer, in any language, and everything that lies beside it. */
(function () {
    var HAND_OFF = /*HAND_OFF*/ null;

    var ja = String(app.isoLanguage).indexOf("ja") === 0;
    var WORDS = {
        undo: ja ? "Kagezou \u306e\u5f71\u3092\u8aad\u307f\u8fbc\u307f" : "Import Kagezou shadows",
        missing: ja ? "\u30d5\u30a1\u30a4\u30eb\u304c\u898b\u3064\u304b\u308a\u307e\u305b\u3093: " : "This file is missing: ",
        refused: ja ? "After Effects \u3067\u8aad\u307f\u8fbc\u3081\u307e\u305b\u3093: " : "After Effects cannot import this file: ",
        save: ja ? "\u30b9\u30af\u30ea\u30d7\u30c8\u3092\u4fdd\u5b58\u3057\u3066\u304b\u3089\u5b9f\u884c\u3057\u3066\u304f\u3060\u3055\u3044\u3002" : "Run this script from its file, not as pasted text.",
        failed: ja ? "Kagezou: \u8aad\u307f\u8fbc\u307f\u306b\u5931\u6557\u3057\u307e\u3057\u305f\u3002\n" : "Kagezou: the import failed.\n",
        done: ja ? "Kagezou: \u30b3\u30f3\u30dd\u30b8\u30b7\u30e7\u30f3\u3092\u66f4\u65b0\u3057\u307e\u3057\u305f: " : "Kagezou: this composition is up to date: "
    };

    /* Items and layers are known by what is written in their comments: names are the user's to change. */
    function tagOf(tag) {
        return "kagezou:" + HAND_OFF.project + ":" + tag;
    }

    function findItem(tag) {
        var wanted = tagOf(tag);
        for (var i = 1; i <= app.project.numItems; i++) {
            if (app.project.item(i).comment === wanted) {
                return app.project.item(i);
            }
        }
        return null;
    }

    function findLayer(comp, tag) {
        var wanted = tagOf(tag);
        for (var i = 1; i <= comp.numLayers; i++) {
            if (comp.layer(i).comment === wanted) {
                return comp.layer(i);
            }
        }
        return null;
    }

    function folderOf(name, parent) {
        var found = /** @type {FolderItem} */ (findItem("folder:" + name));
        if (found === null) {
            found = app.project.items.addFolder(name);
            found.comment = tagOf("folder:" + name);
            found.parentFolder = parent;
        }
        return found;
    }

    function fileOf(path) {
        var absolute = path.charAt(0) === "/" || path.charAt(1) === ":";
        var file = absolute ? new File(path) : new File(new File($.fileName).parent.fsName + "/" + path);
        if (!file.exists) {
            throw new Error(WORDS.missing + file.fsName);
        }
        return file;
    }

    function importFootage(footage, root) {
        var file = fileOf(footage.path);
        var item = /** @type {FootageItem} */ (findItem(footage.tag));
        if (item !== null) {
            if (footage.count > 1) {
                item.replaceWithSequence(file, false);
            } else {
                item.replace(file);
            }
        } else {
            var options = new ImportOptions(file);
            if (!options.canImportAs(ImportAsType.FOOTAGE)) {
                throw new Error(WORDS.refused + file.fsName);
            }
            options.importAs = ImportAsType.FOOTAGE;
            options.sequence = footage.count > 1;
            options.forceAlphabetical = false;
            item = /** @type {FootageItem} */ (app.project.importFile(options));
            item.name = footage.name;
            item.comment = tagOf(footage.tag);
            item.parentFolder = folderOf(footage.folder, root);
        }
        var source = item.mainSource;
        if (!source.isStill) {
            source.conformFrameRate = HAND_OFF.frame_rate;
        }
        if (source.hasAlpha) {
            source.alphaMode = /** @type {any} */ (AlphaMode[footage.alpha]);
            if (footage.alpha === "PREMULTIPLIED") {
                source.premulColor = [0, 0, 0];
            }
        }
        return item;
    }

    function clearKeys(property) {
        while (property.numKeys > 0) {
            property.removeKey(property.numKeys);
        }
    }

    /* Ours first and then the others away: time remapping must never be without a key. */
    function setKeys(property, times, values) {
        property.setValuesAtTimes(times, values);
        for (var i = property.numKeys; i >= 1; i--) {
            var near = 1e9;
            for (var j = 0; j < times.length; j++) {
                near = Math.min(near, Math.abs(property.keyTime(i) - times[j]));
            }
            if (near * HAND_OFF.frame_rate > 0.25) {
                property.removeKey(i);
            }
        }
    }

    function animate(property, channel) {
        if (channel.keys.length === 0) {
            clearKeys(property);
            property.setValue(channel.value);
            return;
        }
        var times = [];
        var values = [];
        var i;
        for (i = 0; i < channel.keys.length; i++) {
            times.push(channel.keys[i].time);
            values.push(channel.keys[i].value);
        }
        setKeys(property, times, values);
        for (i = 0; i < channel.keys.length; i++) {
            var key = channel.keys[i];
            if (key.into === "BEZIER" || key.out === "BEZIER") {
                var into = new KeyframeEase(key.ease_in[0], key.ease_in[1]);
                var out = new KeyframeEase(key.ease_out[0], key.ease_out[1]);
                property.setTemporalEaseAtKey(i + 1, [into], [out]);
            }
            /* Behind the eases, for these make both sides bezier. */
            property.setInterpolationTypeAtKey(i + 1, KeyframeInterpolationType[key.into], KeyframeInterpolationType[key.out]);
        }
    }

    function hold(property, times, values) {
        setKeys(property, times, values);
        for (var i = 1; i <= property.numKeys; i++) {
            property.setInterpolationTypeAtKey(i, KeyframeInterpolationType.HOLD, KeyframeInterpolationType.HOLD);
        }
    }

    /* Held pictures: time remapping, and no opacity on empty cels. */
    function remap(layer, held, opacity) {
        var times = [];
        var pictures = [];
        var shown = [];
        var last = 0;
        for (var i = 0; i < held.length; i++) {
            last = held[i][1] === null ? last : held[i][1];
            times.push(held[i][0]);
            /* Half a frame in, so that no rounding ever shows the picture before. */
            pictures.push((last + 0.5) / HAND_OFF.frame_rate);
            shown.push(held[i][1] === null ? 0 : 100);
        }
        if (layer.canSetTimeRemapEnabled) {
            layer.timeRemapEnabled = true;
            hold(layer.property("ADBE Time Remapping"), times, pictures);
        }
        if (opacity) {
            hold(layer.property("ADBE Transform Group").property("ADBE Opacity"), times, shown);
        }
    }

    function hasEmpty(held) {
        for (var i = 0; i < held.length; i++) {
            if (held[i][1] === null) {
                return true;
            }
        }
        return false;
    }

    function mark(property, markers) {
        clearKeys(property);
        for (var i = 0; i < markers.length; i++) {
            var value = new MarkerValue(markers[i].comment);
            value.duration = markers[i].duration;
            property.setValueAtTime(markers[i].time, value);
        }
    }

    function setBounds(layer) {
        layer.startTime = 0;
        layer.inPoint = 0;
        layer.outPoint = HAND_OFF.duration;
    }

    function putLayer(comp, wanted, items, below) {
        var layer = findLayer(comp, wanted.tag);
        var isNew = layer === null;
        if (layer === null) {
            layer = comp.layers.add(items[wanted.footage]);
            if (below) {
                layer.moveAfter(below);
            }
            layer.comment = tagOf(wanted.tag);
            layer.name = wanted.name;
            layer.blendingMode = BlendingMode[wanted.blend];
        }
        layer.startTime = 0;
        var opacity = layer.property("ADBE Transform Group").property("ADBE Opacity");
        animate(opacity, wanted.opacity);
        if (wanted.remap.length > 0) {
            remap(layer, wanted.remap, hasEmpty(wanted.remap));
        }
        setBounds(layer);
        mark(layer.property("ADBE Marker"), wanted.markers);
        if (isNew && wanted.inverted) {
            layer.property("ADBE Effect Parade").addProperty("ADBE Invert");
        }
    }

    function putNull(comp, wanted) {
        var layer = findLayer(comp, wanted.tag);
        if (layer === null) {
            layer = comp.layers.addNull(HAND_OFF.duration);
            layer.comment = tagOf(wanted.tag);
            layer.name = wanted.name;
            layer.enabled = false;
        }
        setBounds(layer);
        var transform = layer.property("ADBE Transform Group");
        transform.property("ADBE Anchor Point").setValue([0, 0]);
        /* Each number has its curve, as in Kagezou; one curve for the whole place would bend others. */
        transform.property("ADBE Position").dimensionsSeparated = true;
        animate(transform.property("ADBE Position_0"), wanted.x);
        animate(transform.property("ADBE Position_1"), wanted.y);
        animate(transform.property("ADBE Rotate Z"), wanted.rotation);
        var effects = layer.property("ADBE Effect Parade");
        for (var i = 0; i < wanted.sliders.length; i++) {
            var effect = effects.property(wanted.sliders[i][0]);
            if (effect === null) {
                effect = effects.addProperty("ADBE Slider Control");
                effect.name = wanted.sliders[i][0];
                /* Adding an effect makes the others' objects stale. */
                effect = effects.property(wanted.sliders[i][0]);
            }
            animate(effect.property("ADBE Slider Control-0001"), wanted.sliders[i][1]);
        }
    }

    function putWhite(comp) {
        if (findLayer(comp, "white") === null) {
            var layer = comp.layers.addSolid([1, 1, 1], "White", HAND_OFF.width, HAND_OFF.height, 1, HAND_OFF.duration);
            layer.comment = tagOf("white");
            layer.source.parentFolder = comp.parentFolder;
        }
    }

    /* From the panel: shadows and guides into a composition that is there, under its character. */
    function fillComp(target, wanted, items) {
        var i;
        for (i = wanted.layers.length - 1; i >= 0; i--) {
            if (wanted.layers[i].tag.indexOf("shadow:") === 0) {
                putLayer(target.comp, wanted.layers[i], items, target.below);
            }
        }
        for (i = 0; i < wanted.nulls.length; i++) {
            putNull(target.comp, wanted.nulls[i]);
        }
        return target.comp;
    }

    function isNeeded(footage, target) {
        return !target || footage.tag.indexOf("shadow:") === 0;
    }

    function buildComp(wanted, items, root) {
        var comp = /** @type {CompItem} */ (findItem("comp:" + wanted.tag));
        if (comp === null) {
            comp = app.project.items.addComp(wanted.name, HAND_OFF.width, HAND_OFF.height, 1, HAND_OFF.duration, HAND_OFF.frame_rate);
            comp.comment = tagOf("comp:" + wanted.tag);
            comp.parentFolder = root;
        } else {
            comp.width = HAND_OFF.width;
            comp.height = HAND_OFF.height;
            comp.frameRate = HAND_OFF.frame_rate;
            comp.duration = HAND_OFF.duration;
        }
        comp.workAreaStart = 0;
        comp.workAreaDuration = HAND_OFF.work_area[1];
        comp.workAreaStart = HAND_OFF.work_area[0];
        var i;
        if (wanted.white) {
            putWhite(comp);
        }
        /* A layer is added on top, so the lowest comes first. */
        for (i = 0; i < wanted.layers.length; i++) {
            putLayer(comp, wanted.layers[i], items, null);
        }
        for (i = 0; i < wanted.nulls.length; i++) {
            putNull(comp, wanted.nulls[i]);
        }
        mark(comp.markerProperty, wanted.markers);
        return comp;
    }

    function build() {
        if (!$.fileName) {
            throw new Error(WORDS.save);
        }
        if (app.project === null) {
            app.newProject();
        }
        var root = folderOf(HAND_OFF.name, app.project.rootFolder);
        var target = $.global.KAGEZOU_TARGET || null;
        var items = {};
        var comp = null;
        var i;
        for (i = 0; i < HAND_OFF.footage.length; i++) {
            if (isNeeded(HAND_OFF.footage[i], target)) {
                items[HAND_OFF.footage[i].tag] = importFootage(HAND_OFF.footage[i], root);
            }
        }
        if (target) {
            /* The main composition comes last. */
            return fillComp(target, HAND_OFF.comps[HAND_OFF.comps.length - 1], items);
        }
        for (i = 0; i < HAND_OFF.comps.length; i++) {
            comp = buildComp(HAND_OFF.comps[i], items, root);
        }
        return comp;
    }

    app.beginUndoGroup(WORDS.undo);
    try {
        var made = build();
        if (made !== null) {
            made.openInViewer();
        }
    } catch (problem) {
        alert(WORDS.failed + (problem.message || problem));
    } finally {
        app.endUndoGroup();
    }
}());
