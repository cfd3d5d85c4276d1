    /* Footage: found by its tag, brought up to date in its place. */
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

    /* How items were before this run, by their ids. */
    var sizes = {};

    function measureFootage() {
        for (var i = 0; i < HAND_OFF.footage.length; i++) {
            var found = itemsOfFootage(HAND_OFF.footage[i].tag);
            for (var j = 0; j < found.length; j++) {
                sizes["$" + found[j].id] = { S: sizeOf(found[j]), D: String(roundedTime(found[j].duration)), q: stateOfFootage(found[j]) };
            }
        }
    }

    /** @param {AVItem} item */
    function sizeOf(item) {
        return item.width + "x" + item.height;
    }

    /** @param {any} item */
    function stateOfFootage(item) {
        var source = item.mainSource;
        var rate = source.isStill ? "still" : Math.round(source.conformFrameRate * 1000);
        var alpha = "none";
        var modes = ["STRAIGHT", "PREMULTIPLIED", "IGNORE"];
        for (var i = 0; i < modes.length; i++) {
            if (source.hasAlpha && source.alphaMode === AlphaMode[modes[i]]) {
                alpha = modes[i];
            }
        }
        return rate + "/" + alpha + "/" + Math.round(item.pixelAspect * 1000);
    }

    function slashed(path) {
        return path.toLowerCase().replace(/\\/g, "/");
    }

    /* The last parts of a path, as many as the hand-off's own has: they stay when all of it is moved. */
    function tailOf(path, count) {
        return checksum(slashed(path).split("/").slice(-count).join("/"));
    }

    /**
     * @param {any} item
     * @param {any} footage
     * @param {any} memory
     */
    function rememberFile(item, footage, memory) {
        var path = item.mainSource.file.fsName;
        var count = footage.path.replace(/^(\.\.\/)+/, "").split("/").length;
        memory.f = checksum(slashed(path));
        memory.t = count + "." + tailOf(path, count);
    }

    /* Whether an item still shows the file that it was left with, or one that is no longer there. */
    /**
     * @param {any} item
     * @param {any} memory
     */
    function hasOwnFile(item, memory) {
        var file = item.mainSource.file;
        if (memory.f === undefined || item.footageMissing) {
            return true;
        }
        if (!file) {
            return false;
        }
        var tail = memory.t.split(".");
        return memory.f === checksum(slashed(file.fsName)) || tail[1] === tailOf(file.fsName, Number(tail[0]));
    }

    /**
     * @param {FootageItem} item
     * @param {any} footage
     */
    function updateFootage(item, footage) {
        var memory = readComment(item.comment).memory;
        if (!hasOwnFile(item, memory)) {
            tellLeft(item.name, "f");
            return;
        }
        var file = fileOf(footage);
        if (footage.count > 1) {
            item.replaceWithSequence(file, false);
        } else {
            item.replace(file);
        }
        var before = sizes["$" + item.id];
        if (memory.q === undefined || memory.q === before.q) {
            interpret(item, footage);
            memory.q = stateOfFootage(item);
        } else {
            tellLeft(item.name, "q");
        }
        followItemName(item, footage.name, memory);
        if (before.S !== sizeOf(item)) {
            tellChanged(item.name, "S");
        }
        if (before.D !== String(roundedTime(item.duration))) {
            tellChanged(item.name, "D");
        }
        rememberFile(item, footage, memory);
        remember(item, coded(footage.tag), memory);
    }

    function importFootage(footage, root) {
        var file = fileOf(footage);
        var options = new ImportOptions(file);
        if (!options.canImportAs(ImportAsType.FOOTAGE)) {
            throw new Error(WORDS.refused + file.fsName);
        }
        options.importAs = ImportAsType.FOOTAGE;
        options.sequence = footage.count > 1;
        options.forceAlphabetical = false;
        var item = /** @type {FootageItem} */ (app.project.importFile(options));
        item.name = footage.name;
        item.parentFolder = folderOf(footage.folder, folderOf("Footage", root));
        if (footage.label > 0) {
            item.label = footage.label;
        }
        interpret(item, footage);
        keepItem(item, coded(footage.tag));
        var memory = { q: stateOfFootage(item), h: checksum(footage.name) };
        rememberFile(item, footage, memory);
        remember(item, coded(footage.tag), memory);
        return item;
    }

    /**
     * @param {AVItem} item
     * @param {string} name
     * @param {any} memory
     */
    function followItemName(item, name, memory) {
        if (memory.h !== undefined && memory.h !== checksum(item.name)) {
            tellLeft(item.name, "h");
            return;
        }
        if (item.name !== name) {
            tellChanged(item.name, "h");
            item.name = name;
        }
        memory.h = checksum(name);
    }

    /**
     * @param {FootageItem} item
     * @param {any} footage
     */
    function interpret(item, footage) {
        var source = item.mainSource;
        /* Rules of interpretation may take a size for one of video with oblong pixels. */
        item.pixelAspect = 1;
        if (!source.isStill) {
            source.conformFrameRate = HAND_OFF.frame_rate;
        }
        if (source.hasAlpha) {
            source.alphaMode = /** @type {any} */ (AlphaMode[footage.alpha]);
            if (footage.alpha === "PREMULTIPLIED") {
                source.premulColor = [0, 0, 0];
            }
        }
    }
