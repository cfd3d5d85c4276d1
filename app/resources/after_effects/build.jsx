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
        kept: ja ? "Kagezou: After Effects \u3067\u5909\u66f4\u3055\u308c\u305f\u6b21\u306e\u30ec\u30a4\u30e4\u30fc\u306e\u4e0d\u900f\u660e\u5ea6\u306f\u305d\u306e\u307e\u307e\u6b8b\u3057\u307e\u3057\u305f:\n" : "Kagezou: the opacity of these layers was changed in After Effects and is left as it is:\n",
        placed: ja ? "Kagezou: After Effects \u3067\u5909\u66f4\u3055\u308c\u305f\u6b21\u306e\u30ec\u30a4\u30e4\u30fc\u306e\u30c8\u30e9\u30f3\u30b9\u30d5\u30a9\u30fc\u30e0\u306f\u305d\u306e\u307e\u307e\u6b8b\u3057\u307e\u3057\u305f:\n" : "Kagezou: the transform of these layers was changed in After Effects and is left as it is:\n",
        gone: ja ? "Kagezou: \u6b21\u306e\u30ec\u30a4\u30e4\u30fc\u306f Kagezou \u306e\u30d7\u30ed\u30b8\u30a7\u30af\u30c8\u306b\u3082\u3046\u306a\u3044\u305f\u3081\u3001\u975e\u8868\u793a\u306b\u3057\u307e\u3057\u305f:\n" : "Kagezou: these layers are no longer in the Kagezou project and were switched off:\n",
        other: ja ? "\u540c\u3058\u540d\u524d\u306e Kagezou \u306e\u5f71\u304c\u3001\u5225\u306e\u30d5\u30a9\u30eb\u30c0\u30fc\u304b\u3089\u3059\u3067\u306b\u8aad\u307f\u8fbc\u307e\u308c\u3066\u3044\u307e\u3059:\n" : "Kagezou shadows of the same name are already in this project, from another folder:\n",
        replace: ja ? "\n\n\u3053\u306e\u30d5\u30a9\u30eb\u30c0\u30fc\u306e\u5185\u5bb9\u3067\u7f6e\u304d\u63db\u3048\u307e\u3059\u304b\uff1f\u300c\u3044\u3044\u3048\u300d\u3067\u306f\u5225\u306e\u30ab\u30c3\u30c8\u3068\u3057\u3066\u4e26\u3079\u3066\u8aad\u307f\u8fbc\u307f\u307e\u3059\u3002" : "\n\nReplace them with those of this folder? With No they are imported beside them, as another cut."
    };

    var identity = "";
    var title = "";
    var known = {};
    /* How large footage was before this run, by its tag. */
    var sizes = {};
    var kept = [];
    var placed = [];
    var gone = [];

    /* Importing takes a while; few items are there before a window would be. */
    var FEW = 20;
    var progress = null;

    function showProgress(whole) {
        if (whole > FEW) {
            var palette = new Window("palette", "Kagezou");
            progress = { palette: palette, bar: palette.add("progressbar", [0, 0, 320, 12], 0, whole) };
            palette.show();
        }
    }

    function step() {
        if (progress !== null) {
            progress.bar.value += 1;
            progress.palette.update();
        }
    }

    function endProgress() {
        if (progress !== null) {
            progress.palette.close();
            progress = null;
        }
    }

    /* Items and layers are known by what is written in their comments: names are the user's to change. */
    function tagOf(tag) {
        return "kagezou:" + identity + ":" + tag;
    }

    /* Once for all, for a project may hold thousands of items. */
    function listItems() {
        for (var i = 1; i <= app.project.numItems; i++) {
            var item = app.project.item(i);
            if (item.comment.indexOf("kagezou:") === 0) {
                /* The panel writes behind it which project is the composition's own. */
                known["$" + item.comment.replace(/\s?kagezou-project: .*$/, "")] = item;
            }
        }
    }

    function findItem(tag) {
        return known["$" + tagOf(tag)] || null;
    }

    function keepItem(item, tag) {
        item.comment = tagOf(tag);
        known["$" + item.comment] = item;
    }

    /* Behind the tag of a layer stands, after " #", how the script left it. */
    function findLayer(comp, tag) {
        var wanted = tagOf(tag);
        for (var i = 1; i <= comp.numLayers; i++) {
            var comment = comp.layer(i).comment;
            if (comment === wanted || comment.indexOf(wanted + " #") === 0) {
                return comp.layer(i);
            }
        }
        return null;
    }

    function checksum(text) {
        var sum = 7;
        for (var i = 0; i < text.length; i++) {
            sum = (sum * 31 + text.charCodeAt(i)) % 4294967296;
        }
        return sum.toString(36);
    }

    /* Rounded past the middle, so that a number that comes back with another last digit is the same. */
    function rounded(number) {
        return Math.round(number * 10 + 0.23);
    }

    function stateOf(property, shift) {
        return stateOfPart(property, shift, -1);
    }

    /* Of a property of several numbers one of them, from 0; -1 for a number. A place has one ease for all of them. */
    function stateOfPart(property, shift, part) {
        if (property.numKeys === 0) {
            return checksum(String(rounded(numberOf(property.value, part))));
        }
        var said = [];
        for (var i = 1; i <= property.numKeys; i++) {
            var into = property.keyInTemporalEase(i);
            var out = property.keyOutTemporalEase(i);
            var ease = Math.min(Math.max(part, 0), into.length - 1);
            said.push(rounded((property.keyTime(i) - shift) * HAND_OFF.frame_rate), rounded(numberOf(property.keyValue(i), part)));
            said.push(String(property.keyInInterpolationType(i)), String(property.keyOutInterpolationType(i)));
            said.push(rounded(into[ease].influence), rounded(out[ease].influence));
        }
        return checksum(said.join(" "));
    }

    function numberOf(value, part) {
        return part < 0 ? value : value[part];
    }

    /* How a layer lies, moves and turns. */
    function stateOfPlace(layer) {
        var transform = layer.property("ADBE Transform Group");
        var shift = layer.startTime;
        var position = transform.property("ADBE Position");
        var said = [stateOf(transform.property("ADBE Rotate Z"), shift)];
        for (var part = 0; part < 2; part++) {
            said.push(stateOfPart(transform.property("ADBE Anchor Point"), shift, part), stateOfPart(transform.property("ADBE Scale"), shift, part));
            said.push(position.dimensionsSeparated ? stateOf(transform.property("ADBE Position_" + part), shift) : "one" + stateOfPart(position, shift, part));
        }
        return checksum(said.join(" "));
    }

    function boundsOf(layer) {
        var said = [layer.startTime, layer.inPoint, layer.outPoint];
        for (var i = 0; i < said.length; i++) {
            said[i] = rounded(said[i] * HAND_OFF.frame_rate);
        }
        return checksum(said.join(" "));
    }

    /* What was written down the last time; empty texts where nothing was, as by older versions. */
    function memoryOf(layer) {
        var parts = (layer.comment.split(" #")[layer.comment.split(" #").length - 1] || "").split(",");
        var isThere = layer.comment.indexOf(" #") >= 0 && parts.length >= 4;
        return { opacity: isThere ? parts[0] : "", bounds: isThere ? parts[1] : "", remap: isThere ? parts[2] : "r", gone: isThere && parts[3] === "off", colors: parts[4] || "", place: parts[5] || "" };
    }

    function remember(layer, tag, memory) {
        var said = [memory.opacity, memory.bounds, memory.remap, memory.gone ? "off" : "on"];
        if (memory.colors || memory.place) {
            said.push(memory.colors);
        }
        layer.comment = tagOf(tag) + " #" + said.concat(memory.place ? [memory.place] : []).join(",");
    }

    function folderOf(name, parent) {
        var found = /** @type {FolderItem} */ (findItem("folder:" + name));
        if (found === null) {
            found = app.project.items.addFolder(name);
            keepItem(found, "folder:" + name);
            found.parentFolder = parent;
        }
        return found;
    }

    function hereOf() {
        return new File($.fileName).parent.fsName;
    }

    /* File takes what looks like an escape of a URI for one. */
    function fileAt(path) {
        return new File(path.replace(/%(?=[0-9a-fA-F]{2})/g, "%25"));
    }

    function isAbsolute(path) {
        return path.charAt(0) === "/" || path.charAt(1) === ":";
    }

    /* From the script's folder first: all of it may have been moved together. */
    function fileOf(footage) {
        var path = footage.path;
        var base = hereOf();
        while (path.indexOf("../") === 0) {
            path = path.substring(3);
            base = fileAt(base).parent.fsName;
        }
        var file = fileAt(isAbsolute(path) ? path : base + "/" + path);
        if (!file.exists && footage.absolute !== "") {
            file = fileAt(footage.absolute);
        }
        if (!file.exists) {
            throw new Error(WORDS.missing + file.fsName);
        }
        return file;
    }

    function importFootage(footage, root) {
        var file = fileOf(footage);
        var item = /** @type {FootageItem} */ (findItem(footage.tag));
        if (item !== null) {
            sizes[footage.tag] = { width: item.width, height: item.height };
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
            keepItem(item, footage.tag);
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
        var j = times.length - 1;
        for (var i = property.numKeys; i >= 1; i--) {
            var time = property.keyTime(i);
            while (j > 0 && Math.abs(times[j - 1] - time) <= Math.abs(times[j] - time)) {
                j--;
            }
            if (Math.abs(times[j] - time) * HAND_OFF.frame_rate > 0.25) {
                property.removeKey(i);
            }
        }
    }

    function animate(property, channel, shift) {
        if (channel.keys.length === 0) {
            clearKeys(property);
            property.setValue(channel.value);
            return;
        }
        var times = [];
        var values = [];
        var i;
        for (i = 0; i < channel.keys.length; i++) {
            times.push(channel.keys[i].time + shift);
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

    /* Two numbers of one property, with straight lines between places. */
    function animatePair(property, pair, shift) {
        if (pair.keys.length === 0) {
            clearKeys(property);
            property.setValue(pair.value);
            return;
        }
        var times = [];
        var values = [];
        var i;
        for (i = 0; i < pair.keys.length; i++) {
            times.push(pair.keys[i].time + shift);
            values.push(pair.keys[i].value);
        }
        setKeys(property, times, values);
        for (i = 0; i < pair.keys.length; i++) {
            var key = pair.keys[i];
            if (property.isSpatial) {
                var straight = zeros(property.keyInSpatialTangent(i + 1).length);
                property.setSpatialAutoBezierAtKey(i + 1, false);
                property.setSpatialTangentsAtKey(i + 1, straight, straight);
            } else if (key.into === "BEZIER" || key.out === "BEZIER") {
                var count = property.keyInTemporalEase(i + 1).length;
                property.setTemporalEaseAtKey(i + 1, eases(key.ease_in, count), eases(key.ease_out, count));
            }
            property.setInterpolationTypeAtKey(i + 1, KeyframeInterpolationType[key.into], KeyframeInterpolationType[key.out]);
        }
    }

    function zeros(count) {
        var made = [];
        for (var i = 0; i < count; i++) {
            made.push(0);
        }
        return made;
    }

    /* A flat layer's scale too has a third number, and wants an ease for it. */
    function eases(known, count) {
        var made = [];
        for (var i = 0; i < count; i++) {
            var ease = known[Math.min(i, known.length - 1)];
            made.push(new KeyframeEase(ease[0], ease[1]));
        }
        return made;
    }

    function hold(property, times, values) {
        setKeys(property, times, values);
        for (var i = 1; i <= property.numKeys; i++) {
            property.setInterpolationTypeAtKey(i, KeyframeInterpolationType.HOLD, KeyframeInterpolationType.HOLD);
        }
    }

    /* Held pictures: time remapping. */
    function remap(layer, held, shift) {
        var times = [];
        var pictures = [];
        var last = 0;
        for (var i = 0; i < held.length; i++) {
            last = held[i][1] === null ? last : held[i][1];
            times.push(held[i][0] + shift);
            /* Half a frame in, so that no rounding ever shows the picture before. */
            pictures.push((last + 0.5) / HAND_OFF.frame_rate);
        }
        if (layer.canSetTimeRemapEnabled) {
            layer.timeRemapEnabled = true;
            hold(layer.property("ADBE Time Remapping"), times, pictures);
        }
    }

    /* Shift Channels: what alpha, red, green and blue are taken from. */
    var ALPHA = 1;
    var RED = 2;
    var FULL_ON = 9;

    function shiftChannels(layer, sources) {
        var effect = layer.property("ADBE Effect Parade").addProperty("ADBE Shift Channels");
        for (var i = 0; i < sources.length; i++) {
            effect.property("ADBE Shift Channels-000" + (i + 1)).setValue(sources[i]);
        }
    }

    /* The colour of a united shadow, null where the user took the effect away. */
    function fillOf(layer) {
        var effects = layer.property("ADBE Effect Parade");
        for (var i = 1; i <= effects.numProperties; i++) {
            if (effects.property(i).matchName === "ADBE Fill") {
                return effects.property(i).property("ADBE Fill-0002");
            }
        }
        return null;
    }

    function stateOfColors(property, shift) {
        var said = [];
        for (var i = 1; i <= Math.max(property.numKeys, 1); i++) {
            var color = property.numKeys > 0 ? property.keyValue(i) : property.value;
            said.push(property.numKeys > 0 ? rounded((property.keyTime(i) - shift) * HAND_OFF.frame_rate) : 0);
            for (var j = 0; j < 3; j++) {
                said.push(Math.round(color[j] * 255));
            }
        }
        return checksum(said.join(" "));
    }

    /* A user's own colour stays. */
    function setColors(layer, colors, memory) {
        var property = fillOf(layer);
        if (property === null || (memory.colors !== "" && memory.colors !== stateOfColors(property, layer.startTime))) {
            return;
        }
        var times = [];
        var values = [];
        for (var i = 0; i < colors.length; i++) {
            times.push(colors[i][0] + layer.startTime);
            values.push([colors[i][1][0], colors[i][1][1], colors[i][1][2], 1]);
        }
        if (times.length === 1) {
            clearKeys(property);
            property.setValue(values[0]);
        } else {
            hold(property, times, values);
        }
        memory.colors = stateOfColors(property, layer.startTime);
    }

    /* No opacity on empty cels. */
    function showHeld(opacity, held, shift) {
        var times = [];
        var shown = [];
        for (var i = 0; i < held.length; i++) {
            times.push(held[i][0] + shift);
            shown.push(held[i][1] === null ? 0 : 100);
        }
        hold(opacity, times, shown);
    }

    function hasEmpty(held) {
        for (var i = 0; i < held.length; i++) {
            if (held[i][1] === null) {
                return true;
            }
        }
        return false;
    }

    /* Markers of the user stay; ours carry our name as their cue point. One on the same frame takes our words along. */
    function mark(property, markers, shift) {
        var i;
        for (i = property.numKeys; i >= 1; i--) {
            if (property.keyValue(i).cuePointName === "kagezou") {
                property.removeKey(i);
            }
        }
        for (i = 0; i < markers.length; i++) {
            var time = markers[i].time + shift;
            var value = new MarkerValue(markers[i].comment);
            var near = property.numKeys > 0 ? property.nearestKeyIndex(time) : 0;
            if (near > 0 && Math.abs(property.keyTime(near) - time) * HAND_OFF.frame_rate < 0.5) {
                value = property.keyValue(near);
                time = property.keyTime(near);
                if (value.comment.indexOf(markers[i].comment) < 0) {
                    value.comment = value.comment + "\n" + markers[i].comment;
                }
            } else {
                value.cuePointName = "kagezou";
                value.duration = markers[i].duration;
            }
            property.setValueAtTime(time, value);
        }
    }

    function setBounds(layer) {
        layer.startTime = 0;
        layer.inPoint = 0;
        layer.outPoint = HAND_OFF.duration;
    }

    /* On whole pixels, as Kagezou lays it; the middle alone would blur it. */
    function middleOf(comp, source) {
        var left = Math.floor((comp.width - source.width) / 2);
        var top = Math.floor((comp.height - source.height) / 2);
        return [left + source.width / 2, top + source.height / 2];
    }

    function isInMiddle(comp, layer, size) {
        var transform = layer.property("ADBE Transform Group");
        var position = transform.property("ADBE Position");
        var scale = transform.property("ADBE Scale");
        var anchor = transform.property("ADBE Anchor Point");
        var turned = transform.property("ADBE Rotate Z");
        if (position.dimensionsSeparated || position.numKeys + scale.numKeys + anchor.numKeys + turned.numKeys > 0 || turned.value !== 0) {
            return false;
        }
        var middle = middleOf(comp, size);
        for (var i = 0; i < 2; i++) {
            var side = i === 0 ? size.width : size.height;
            if (Math.abs(scale.value[i] - 100) > 0.01 || Math.abs(position.value[i] - anchor.value[i] - middle[i] + side / 2) > 0.51) {
                return false;
            }
        }
        return true;
    }

    function putInMiddle(comp, layer) {
        var transform = layer.property("ADBE Transform Group");
        var position = transform.property("ADBE Position");
        if (position.dimensionsSeparated) {
            clearKeys(transform.property("ADBE Position_0"));
            clearKeys(transform.property("ADBE Position_1"));
            position.dimensionsSeparated = false;
        }
        clearKeys(position);
        position.setValue(middleOf(comp, layer.source));
        animatePair(transform.property("ADBE Anchor Point"), { value: [layer.source.width / 2, layer.source.height / 2], keys: [] }, 0);
        animatePair(transform.property("ADBE Scale"), { value: [100, 100], keys: [] }, 0);
        animate(transform.property("ADBE Rotate Z"), { value: 0, keys: [] }, 0);
    }

    /* A layer that the user moved stays where it is. */
    function setPlace(comp, layer, tag, wanted, memory) {
        /* Footage of another size leaves the anchor where it was. */
        var before = sizes[tag] || layer.source;
        var isOurs = memory.place === "" ? isInMiddle(comp, layer, before) : memory.place === stateOfPlace(layer);
        var isAlike = before.width === layer.source.width && before.height === layer.source.height;
        if (!wanted && memory.place === "" && (isAlike || !isOurs)) {
            return;
        }
        if (!isOurs) {
            placed.push(layer.name);
            return;
        }
        if (!wanted) {
            putInMiddle(comp, layer);
            memory.place = "";
            return;
        }
        var transform = layer.property("ADBE Transform Group");
        /* Each number has its curve, as in Kagezou. */
        transform.property("ADBE Position").dimensionsSeparated = true;
        animate(transform.property("ADBE Position_0"), wanted.x, layer.startTime);
        animate(transform.property("ADBE Position_1"), wanted.y, layer.startTime);
        animatePair(transform.property("ADBE Anchor Point"), wanted.anchor, layer.startTime);
        animatePair(transform.property("ADBE Scale"), wanted.scale, layer.startTime);
        animate(transform.property("ADBE Rotate Z"), wanted.rotation, layer.startTime);
        memory.place = stateOfPlace(layer);
    }

    function addLayer(comp, wanted, items) {
        var layer = comp.layers.add(items[wanted.footage]);
        layer.name = wanted.name;
        layer.blendingMode = BlendingMode[wanted.blend];
        layer.startTime = 0;
        var source = items[wanted.footage];
        if ((comp.width - source.width) % 2 !== 0 || (comp.height - source.height) % 2 !== 0) {
            layer.property("ADBE Transform Group").property("ADBE Position").setValue(middleOf(comp, source));
        }
        return layer;
    }

    /* Only what is as the script left it is changed: place, opacity and trimming of the user's own stay. */
    function putLayer(comp, wanted, items) {
        var layer = findLayer(comp, wanted.tag);
        var isNew = layer === null;
        if (layer === null) {
            layer = addLayer(comp, wanted, items);
            layer.comment = tagOf(wanted.tag);
        }
        var memory = memoryOf(layer);
        var shift = layer.startTime;
        if (memory.gone) {
            layer.enabled = true;
            memory.gone = false;
        }
        if (wanted.remap.length > 0) {
            remap(layer, wanted.remap, shift);
            memory.remap = "r";
        } else if (memory.remap === "r") {
            if (layer.timeRemapEnabled) {
                layer.timeRemapEnabled = false;
            }
            memory.remap = "";
        }
        var opacity = layer.property("ADBE Transform Group").property("ADBE Opacity");
        if (memory.opacity === "" || memory.opacity === stateOf(opacity, shift)) {
            animate(opacity, wanted.opacity, shift);
            if (hasEmpty(wanted.remap)) {
                showHeld(opacity, wanted.remap, shift);
            }
            memory.opacity = stateOf(opacity, shift);
        } else {
            kept.push(layer.name);
        }
        setPlace(comp, layer, wanted.footage, wanted.transform, memory);
        if (memory.bounds === "" || memory.bounds === boundsOf(layer)) {
            setBounds(layer);
            memory.bounds = boundsOf(layer);
        }
        mark(layer.property("ADBE Marker"), wanted.markers, shift);
        if (isNew && wanted.inverted) {
            layer.property("ADBE Effect Parade").addProperty("ADBE Invert");
        }
        if (isNew && wanted.alpha_shown) {
            shiftChannels(layer, [FULL_ON, ALPHA, ALPHA, ALPHA]);
        }
        if (wanted.colors.length > 0) {
            if (isNew) {
                shiftChannels(layer, [RED]);
                layer.property("ADBE Effect Parade").addProperty("ADBE Fill");
            }
            setColors(layer, wanted.colors, memory);
        }
        remember(layer, wanted.tag, memory);
        step();
        return { layer: layer, isNew: isNew };
    }

    /* What the project no longer has is switched off, not deleted: there may be work on it. */
    function switchOff(comp, layers, kinds) {
        var wanted = {};
        var i;
        for (i = 0; i < layers.length; i++) {
            wanted["$" + tagOf(layers[i].tag)] = true;
        }
        for (i = 1; i <= comp.numLayers; i++) {
            var layer = comp.layer(i);
            var tag = layer.comment.split(" #").slice(0, -1).join(" #");
            var kind = tag.indexOf(tagOf("")) === 0 ? tag.substring(tagOf("").length).split(":")[0] : "";
            var memory = memoryOf(layer);
            if (kind !== "" && kinds.indexOf("|" + kind + "|") >= 0 && !wanted["$" + tag] && !memory.gone) {
                layer.enabled = false;
                memory.gone = true;
                remember(layer, tag.substring(tagOf("").length), memory);
                gone.push(layer.name);
            }
        }
    }

    function putNull(comp, wanted) {
        var layer = findLayer(comp, wanted.tag);
        if (layer === null) {
            layer = comp.layers.addNull(HAND_OFF.duration);
            layer.comment = tagOf(wanted.tag);
            layer.name = wanted.name;
            layer.enabled = false;
            layer.property("ADBE Transform Group").property("ADBE Anchor Point").setValue([0, 0]);
        }
        setBounds(layer);
        var transform = layer.property("ADBE Transform Group");
        /* Each number has its curve, as in Kagezou; one curve for the whole place would bend others. */
        transform.property("ADBE Position").dimensionsSeparated = true;
        animate(transform.property("ADBE Position_0"), wanted.x, 0);
        animate(transform.property("ADBE Position_1"), wanted.y, 0);
        animate(transform.property("ADBE Rotate Z"), wanted.rotation, 0);
        var effects = layer.property("ADBE Effect Parade");
        for (var i = 0; i < wanted.sliders.length; i++) {
            var effect = effects.property(wanted.sliders[i][0]);
            if (effect === null) {
                effect = effects.addProperty("ADBE Slider Control");
                effect.name = wanted.sliders[i][0];
                /* Adding an effect makes the others' objects stale. */
                effect = effects.property(wanted.sliders[i][0]);
            }
            animate(effect.property("ADBE Slider Control-0001"), wanted.sliders[i][1], 0);
        }
    }

    function putWhite(comp) {
        if (findLayer(comp, "white") === null) {
            var layer = comp.layers.addSolid([1, 1, 1], "White", HAND_OFF.width, HAND_OFF.height, 1, HAND_OFF.duration);
            layer.comment = tagOf("white");
            layer.source.parentFolder = comp.parentFolder;
        }
    }

    /* The character of what others cast on it, by its name, for its layer is the user's own. */
    function characterOf(target, received) {
        var name = received.name.replace(/ received$/, "");
        for (var i = 1; i <= target.comp.numLayers; i++) {
            if (target.comp.layer(i).name === name) {
                return target.comp.layer(i);
            }
        }
        return target.below;
    }

    /* From the panel: shadows and guides into a composition that is there, under its character. */
    function fillComp(target, wanted, items) {
        var shadows = [];
        var i;
        for (i = 0; i < wanted.layers.length; i++) {
            if (isOfShadow(wanted.layers[i].tag)) {
                shadows.push(wanted.layers[i]);
            }
        }
        /* Each goes right under the character, so over those before it; what is cast on a character right over it. */
        for (i = 0; i < shadows.length; i++) {
            var isReceived = shadows[i].tag.indexOf("received:") === 0;
            var beside = isReceived ? characterOf(target, shadows[i]) : target.below;
            var put = putLayer(target.comp, shadows[i], items);
            if (put.isNew && beside && isReceived) {
                put.layer.moveBefore(beside);
            } else if (put.isNew && beside) {
                put.layer.moveAfter(beside);
            }
        }
        for (i = 0; i < wanted.nulls.length; i++) {
            putNull(target.comp, wanted.nulls[i]);
        }
        switchOff(target.comp, shadows, "|shadow|received|");
        return target.comp;
    }

    function isOfShadow(tag) {
        return tag.indexOf("shadow:") === 0 || tag.indexOf("received:") === 0;
    }

    function isNeeded(footage, target) {
        return !target || isOfShadow(footage.tag);
    }

    function buildComp(wanted, items, root) {
        var comp = /** @type {CompItem} */ (findItem("comp:" + wanted.tag));
        if (comp === null) {
            comp = app.project.items.addComp(wanted.name, HAND_OFF.width, HAND_OFF.height, 1, HAND_OFF.duration, HAND_OFF.frame_rate);
            keepItem(comp, "comp:" + wanted.tag);
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
        /* A layer is added on top, so the lowest comes first; one that comes later goes over the one it belongs over. */
        var lower = null;
        for (i = 0; i < wanted.layers.length; i++) {
            var put = putLayer(comp, wanted.layers[i], items);
            if (put.isNew && lower !== null) {
                put.layer.moveBefore(lower);
            } else if (put.isNew && !wanted.white) {
                put.layer.moveToEnd();
            }
            lower = put.layer;
        }
        switchOff(comp, wanted.layers, "|background|shadow|cels|received|lit|");
        for (i = 0; i < wanted.nulls.length; i++) {
            putNull(comp, wanted.nulls[i]);
        }
        mark(comp.markerProperty, wanted.markers, 0);
        return comp;
    }

    /* Two cuts may be called alike. Where a hand-off of this name came from a folder that is still there, the user says
       whether this one takes its place; one that lies beside it is known by its folder from then on. */
    function settleIdentity(target) {
        if (target) {
            identity = target.project;
            title = target.name;
            return;
        }
        var here = hereOf();
        title = HAND_OFF.name;
        identity = HAND_OFF.project + "@" + here;
        if (findItem("folder:" + title) !== null) {
            return;
        }
        var beside = identity;
        identity = HAND_OFF.project;
        for (var i = 0; i < HAND_OFF.footage.length; i++) {
            var item = /** @type {FootageItem} */ (findItem(HAND_OFF.footage[i].tag));
            var file = item !== null && item.mainSource.file && HAND_OFF.footage[i].tag.indexOf("shadow:") === 0 ? item.mainSource.file : null;
            if (file && file.exists && file.fsName.toLowerCase().replace(/\\/g, "/").indexOf(here.toLowerCase().replace(/\\/g, "/") + "/") !== 0) {
                if (!confirm(WORDS.other + file.parent.fsName + WORDS.replace)) {
                    identity = beside;
                }
                return;
            }
        }
    }

    function build() {
        if (!$.fileName) {
            throw new Error(WORDS.save);
        }
        if (app.project === null) {
            app.newProject();
        }
        var target = $.global.KAGEZOU_TARGET || null;
        listItems();
        settleIdentity(target);
        var root = folderOf(title, app.project.rootFolder);
        var items = {};
        var comp = null;
        var whole = HAND_OFF.footage.length;
        var i;
        for (i = 0; i < HAND_OFF.comps.length; i++) {
            whole += HAND_OFF.comps[i].layers.length;
        }
        showProgress(whole);
        for (i = 0; i < HAND_OFF.footage.length; i++) {
            step();
            if (isNeeded(HAND_OFF.footage[i], target)) {
                items[HAND_OFF.footage[i].tag] = importFootage(HAND_OFF.footage[i], root);
            }
        }
        /* The main composition comes last, behind those that are layers of it. */
        for (i = 0; i < HAND_OFF.comps.length; i++) {
            var wanted = HAND_OFF.comps[i];
            if (target && i === HAND_OFF.comps.length - 1) {
                return fillComp(target, wanted, items);
            }
            if (!target || wanted.tag.indexOf("united:") === 0) {
                comp = buildComp(wanted, items, root);
                items["comp:" + wanted.tag] = comp;
            }
        }
        return comp;
    }

    function report() {
        var said = [];
        if (kept.length > 0) {
            said.push(WORDS.kept + kept.join("\n"));
        }
        if (placed.length > 0) {
            said.push(WORDS.placed + placed.join("\n"));
        }
        if (gone.length > 0) {
            said.push(WORDS.gone + gone.join("\n"));
        }
        if (said.length > 0) {
            alert(said.join("\n\n"));
        }
    }

    app.beginUndoGroup(WORDS.undo);
    try {
        var made = build();
        if (made !== null) {
            made.openInViewer();
        }
        endProgress();
        report();
    } catch (problem) {
        endProgress();
        alert(WORDS.failed + (problem.message || problem));
    } finally {
        app.endUndoGroup();
    }
}());
