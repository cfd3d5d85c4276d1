    /* Layers that are ours, wherever they are by now, each as it is before anything is changed: footage of another size
       and compositions of another rate would make all of them look changed. */
    /** @typedef {{comp: CompItem, layer: AVLayer, tag: string, memory: any, before: any, isNew: boolean}} Entry */
    /** @type {Entry[]} */
    var entries = [];
    var entriesByTag = {};

    /** @param {Entry} entry */
    function noteEntry(entry) {
        entries.push(entry);
        entriesByTag["$" + entry.tag] = entriesOf(entry.tag).concat([entry]);
    }

    function survey() {
        for (var i = 0; i < comps.length; i++) {
            for (var j = comps[i].numLayers; j >= 1; j--) {
                var layer = /** @type {AVLayer} */ (comps[i].layer(j));
                /* Cameras, lights and texts are the user's, whatever is written on them. */
                var read = layer.source && layer.comment.indexOf("kagezou:") >= 0 ? readComment(layer.comment) : null;
                if (read !== null) {
                    noteEntry({ comp: comps[i], layer: layer, tag: read.tag, memory: read.memory, before: {}, isNew: false });
                }
            }
        }
        for (i = 0; i < comps.length; i++) {
            settleOrigin(comps[i]);
        }
        for (i = 0; i < entries.length; i++) {
            for (var name in STATES) {
                if (STATES.hasOwnProperty(name)) {
                    entries[i].before[name] = STATES[name](entries[i].layer);
                }
            }
            entries[i].before.p = stateOfPlace(entries[i].layer, shiftOf(entries[i].comp));
        }
    }

    /* How far the user moved the canvas since the last time. */
    var shifts = {};

    function shiftOf(comp) {
        return shifts["$" + comp.id] || [0, 0];
    }

    /** @param {CompItem} comp */
    function settleOrigin(comp) {
        var read = readComment(comp.comment);
        var last = read === null || !read.memory.V ? null : read.memory.V.split("/");
        if (last === null) {
            return;
        }
        var shift = [0, 0];
        if (Number(last[0]) !== comp.width || Number(last[1]) !== comp.height) {
            shift = findOrigin(comp, [Number(last[0]), Number(last[1])], entriesIn(comp));
        }
        shifts["$" + comp.id] = shift;
        origins["$" + comp.id] = [Number(last[2]) + shift[0], Number(last[3]) + shift[1]];
    }

    /** @param {CompItem} comp */
    function entriesIn(comp) {
        var found = [];
        for (var i = 0; i < entries.length; i++) {
            if (entries[i].comp.id === comp.id) {
                found.push(entries[i]);
            }
        }
        return found;
    }

    /** @returns {Entry[]} */
    function entriesOf(tag) {
        return entriesByTag["$" + tag] || [];
    }

    /**
     * @param {Entry} entry
     * @param {string} name
     */
    function isLeft(entry, name) {
        return entry.isNew || entry.memory[name] === undefined || entry.memory[name] === entry.before[name];
    }

    /* What is as the script left it follows Kagezou; what the user changed stays, and is said. */
    /**
     * @param {Entry} entry
     * @param {string} name
     * @param {() => void} work
     */
    function follow(entry, name, work) {
        if (!isLeft(entry, name)) {
            tellLeft(nameOfEntry(entry), name);
            return;
        }
        work();
        var seen = name === "p" ? stateOfPlace(entry.layer, shiftOf(entry.comp)) : STATES[name](entry.layer);
        if (!entry.isNew && seen !== entry.before[name] && entry.memory[name] !== undefined) {
            tellChanged(nameOfEntry(entry), name);
        }
        entry.memory[name] = STATES[name](entry.layer);
    }

    /* The layer of a composition that is of a tag, or that has it within; null where there is none. */
    /**
     * @param {CompItem} comp
     * @param {string} tag
     */
    function carrierIn(comp, tag) {
        var sources = [];
        var wanted = entriesOf(tag);
        for (var i = 0; i < wanted.length; i++) {
            if (wanted[i].comp.id === comp.id) {
                return wanted[i].layer;
            }
            sources.push(wanted[i].comp);
        }
        for (i = 1; i <= comp.numLayers && sources.length > 0; i++) {
            if (shows(/** @type {AVLayer} */ (comp.layer(i)), sources)) {
                return comp.layer(i);
            }
        }
        return null;
    }
