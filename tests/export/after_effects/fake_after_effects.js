/* As much of After Effects' object model as the scripts use, with its rules: keys on whole comp times, one blend mode a
   layer, comments, folders. node fake.js OUT TIMES SCRIPT runs SCRIPT so many times and writes what is there as JSON;
   with "edited" and then pairs EDIT SCRIPT it runs what a user does in between and then each further SCRIPT. */
"use strict";
const fs = require("fs");
const path = require("path");
const vm = require("vm");

const [, , outPath, times, scriptPath, mode] = process.argv;
const alerts = [];
const calls = [];
const undo = { open: 0, groups: 0 };

class Property {
    constructor(matchName, value, dimensions) {
        this.matchName = matchName; this.name = matchName; this.value = value; this.dimensions = dimensions || 1;
        this.keys = []; this.enabledKeys = true; this.children = {};
        this.isSpatial = ["ADBE Position", "ADBE Anchor Point"].includes(matchName);
        /* Scale has a third number in flat layers too; a place has one ease for all of its numbers. */
        this.eases = matchName === "ADBE Scale" ? 3 : 1;
    }
    get numKeys() { return this.keys.length; }
    setValue(value) {
        if (this.keys.length) throw new Error("After Effects: a value is set although there are keys: " + this.matchName);
        this._open();
        for (const part of [].concat(value)) if (typeof part === "number" && !Number.isFinite(part)) throw new Error("After Effects: a value is no number");
        this.value = value;
    }
    setValueAtTime(time, value) { this.setValuesAtTimes([time], [value]); }
    _open() { if (this.isShut && this.isShut()) throw new Error("After Effects: hidden by the dimensions: " + this.matchName); }
    setValuesAtTimes(list, values) {
        this._open();
        if (list.length !== values.length) throw new Error("After Effects: times and values differ in number");
        list.forEach((time, i) => {
            if (!Number.isFinite(time)) throw new Error("After Effects: a time is no number");
            for (const part of [].concat(values[i])) if (typeof part === "number" && !Number.isFinite(part)) throw new Error("After Effects: a value is no number");
            const old = this.keys.find((key) => Math.abs(key.time - time) < 1e-9);
            if (old) old.value = values[i];
            else this.keys.push({ time, value: values[i], into: "LINEAR", out: "LINEAR", ease_in: null, ease_out: null, is_curved: this.isSpatial });
        });
        this.keys.sort((a, b) => a.time - b.time);
    }
    keyTime(index) { return this._key(index).time; }
    keyValue(index) { const value = this._key(index).value; if (Array.isArray(value)) return value.slice(); return value !== null && typeof value === "object" ? Object.assign({}, value) : value; }
    keyInInterpolationType(index) { return this._key(index).into; }
    keyOutInterpolationType(index) { return this._key(index).out; }
    keyInTemporalEase(index) { return this._eases(this._key(index).ease_in); }
    keyOutTemporalEase(index) { return this._eases(this._key(index).ease_out); }
    _eases(known) { return known ? [].concat(known) : new Array(this.eases).fill({ speed: 0, influence: 16.666666667 }); }
    keyInSpatialTangent(index) { this._key(index); if (!this.isSpatial) throw new Error("After Effects: no tangents"); return [0, 0, 0]; }
    setSpatialAutoBezierAtKey(index, on) { this._key(index).is_curved = on; }
    setSpatialTangentsAtKey(index, into, out) {
        if (!this.isSpatial || into.length !== 3 || out.length !== 3) throw new Error("After Effects: three tangents");
        this._key(index).is_curved = into.concat(out).some((each) => each !== 0);
    }
    valueAtTime(time) {
        let found = this.keys.length ? this.keys[0].value : this.value;
        this.keys.forEach((key, i) => {
            const next = this.keys[i + 1];
            if (key.time > time) return;
            const part = next && key.out === "LINEAR" && next.time > time ? (time - key.time) / (next.time - key.time) : 0;
            const between = (from, to) => from + (to - from) * part;
            found = part === 0 ? key.value : Array.isArray(key.value) ? key.value.map((each, n) => between(each, next.value[n])) : between(key.value, next.value);
        });
        return found;
    }
    removeKey(index) {
        this._key(index);
        if (this.matchName === "ADBE Time Remapping" && this.keys.length === 1) throw new Error("After Effects: the last key of time remapping");
        this.keys.splice(index - 1, 1);
    }
    nearestKeyIndex(time) {
        let best = 0;
        this.keys.forEach((key, i) => { if (Math.abs(key.time - time) < Math.abs(this.keys[best].time - time)) best = i; });
        return best + 1;
    }
    setTemporalEaseAtKey(index, into, out) {
        if (into.length !== this.eases || out.length !== this.eases) throw new Error("After Effects: one ease a dimension");
        const key = this._key(index);
        Object.assign(key, { ease_in: this.eases > 1 ? into : into[0], ease_out: this.eases > 1 ? out : out[0], into: "BEZIER", out: "BEZIER" });
    }
    setInterpolationTypeAtKey(index, into, out) {
        const key = this._key(index);
        if (into === undefined || out === undefined) throw new Error("After Effects: no such interpolation");
        key.into = into; key.out = out;
    }
    _key(index) {
        if (!(index >= 1 && index <= this.keys.length)) throw new Error("After Effects: no key " + index);
        return this.keys[index - 1];
    }
    property(name) {
        const found = typeof name === "number" ? Object.values(this.children)[name - 1] : this.children[name];
        return found === undefined ? null : found;
    }
    get numProperties() { return Object.keys(this.children).length; }
    dump() {
        const children = {};
        for (const [name, child] of Object.entries(this.children)) children[name] = child.dump();
        return { matchName: this.matchName, value: this.value, keys: this.keys, separated: this.dimensionsSeparated, children };
    }
}

class Effects extends Property {
    addProperty(matchName) {
        const effect = new Property(matchName, null);
        effect.enabled = true;
        const parade = this;
        const parts = {
            "ADBE Slider Control": [0], "ADBE Invert": [], "ADBE Geometry2": [], "ADBE Tint": [], "ADBE Shift Channels": [1, 2, 3, 4], "ADBE Fill": [0, [1, 0, 0, 1]]
        };
        if (!(matchName in parts)) throw new Error("After Effects: no effect " + matchName);
        parts[matchName].forEach((value, i) => {
            const part = `${matchName}-000${i + 1}`;
            effect.children[part] = new Property(part, value);
        });
        let name = matchName;
        Object.defineProperty(effect, "name", {
            get: () => name,
            set: (wanted) => { delete parade.children[name]; name = wanted; parade.children[name] = effect; }
        });
        this.children[name] = effect;
        return effect;
    }
}

class Layer {
    constructor(comp, source, duration) {
        this.comp = comp; this.source = source; this.name = source ? source.name : "Null"; this.comment = "";
        this.blendingMode = BlendingMode.NORMAL; this.enabled = true; this.stretch = 100; this.selected = false;
        this.parent = null; this.threeDLayer = false; this.hasTrackMatte = false; this.autoOrient = "NO";
        this.startTime = 5; this.inPoint = 0; this.outPoint = duration; this._remap = false;
        this._groups = {
            "ADBE Transform Group": new Property("ADBE Transform Group"),
            "ADBE Effect Parade": new Effects("ADBE Effect Parade"),
            "ADBE Marker": new Property("ADBE Marker", null),
            "ADBE Mask Parade": new Property("ADBE Mask Parade"),
            "ADBE Time Remapping": new Property("ADBE Time Remapping", 0)
        };
        const transform = this._groups["ADBE Transform Group"];
        for (const [name, value] of [["ADBE Opacity", 100], ["ADBE Anchor Point", source && source.width ? [source.width / 2, source.height / 2] : [0, 0]], ["ADBE Scale", [100, 100]], ["ADBE Rotate Z", 0], ["ADBE Position_0", 0], ["ADBE Position_1", 0]])
            transform.children[name] = new Property(name, value);
        const position = new Property("ADBE Position", [comp.width / 2, comp.height / 2]);
        let separated = false;
        Object.defineProperty(position, "dimensionsSeparated", {
            get: () => separated,
            set: (on) => {
                if (on && !separated) [0, 1].forEach((i) => { transform.children["ADBE Position_" + i].value = position.value[i]; });
                separated = on;
            }
        });
        position.isShut = () => separated;
        [0, 1].forEach((i) => { transform.children["ADBE Position_" + i].isShut = () => !separated; });
        transform.children["ADBE Position"] = position;
    }
    get index() { return this.comp.all.indexOf(this) + 1; }
    get canSetTimeRemapEnabled() { return Boolean(this.source && !this.source.mainSource.isStill); }
    get timeRemapEnabled() { return this._remap; }
    set timeRemapEnabled(on) {
        if (on && !this._remap) this._groups["ADBE Time Remapping"].setValuesAtTimes([0, this.source.duration], [0, this.source.duration]);
        this._remap = on;
    }
    property(name) {
        if (!(name in this._groups)) throw new Error("After Effects: no property " + name);
        return this._groups[name];
    }
    _move(other, by) {
        if (!(other instanceof Layer) || other === this || other.comp !== this.comp) throw new Error("After Effects: a layer is moved to no other of its comp");
        this.comp.all.splice(this.comp.all.indexOf(this), 1);
        this.comp.all.splice(this.comp.all.indexOf(other) + by, 0, this);
    }
    moveAfter(other) { this._move(other, 1); }
    moveBefore(other) { this._move(other, 0); }
    moveToEnd() { this.comp.all.splice(this.comp.all.indexOf(this), 1); this.comp.all.push(this); }
    dump() {
        const groups = {};
        for (const [name, group] of Object.entries(this._groups)) groups[name] = group.dump();
        return {
            name: this.name, comment: this.comment, blend: this.blendingMode, enabled: this.enabled, inPoint: this.inPoint,
            outPoint: this.outPoint, startTime: this.startTime, source: this.source ? this.source.name : null, remap: this._remap, groups
        };
    }
}

class Item {
    constructor(name) { this.name = name; this.comment = ""; this.parentFolder = project.rootFolder; project.all.push(this); }
}
class FolderItem extends Item {}
class FootageItem extends Item {
    constructor(file, sequence) { super(file.name); this._take(file, sequence); }
    _take(file, sequence) {
        if (!file.exists) throw new Error("After Effects: no such file: " + file.fsName);
        const head = Buffer.alloc(24);
        const opened = fs.openSync(file.fsName, "r"); fs.readSync(opened, head, 0, 24, 0); fs.closeSync(opened);
        const isPng = head.toString("latin1", 1, 4) === "PNG";
        this.width = isPng ? head.readUInt32BE(16) : 4; this.height = isPng ? head.readUInt32BE(20) : 4;
        const still = !sequence;
        let frames = 1;
        if (sequence) {
            const parts = /^(.*?)(\d+)(\.\w+)$/.exec(path.basename(file.fsName));
            const all = fs.readdirSync(path.dirname(file.fsName)).filter((each) => {
                const found = /^(.*?)(\d+)(\.\w+)$/.exec(each);
                return found && found[1] === parts[1] && found[3] === parts[3];
            }).sort();
            frames = all.length;
            all.forEach((each, i) => {
                const number = Number(/(\d+)\.\w+$/.exec(each)[1]);
                if (number !== Number(parts[2]) + i) throw new Error("After Effects: a gap in the sequence " + file.fsName);
            });
        }
        this.frames = frames;
        const item = this;
        this.mainSource = {
            isStill: still, hasAlpha: true, file, alphaMode: null, premulColor: null, rate: 30,
            get conformFrameRate() { return this.isConformed ? this.rate : 0; },
            get displayFrameRate() { return this.rate; },
            set conformFrameRate(rate) {
                if (still) throw new Error("After Effects: a still has no frame rate");
                this.rate = rate; this.isConformed = true; item.duration = frames / rate;
            }
        };
        this.duration = frames / 30;
    }
    replace(file) { calls.push("replace"); this._take(file, false); }
    replaceWithSequence(file, alphabetical) { calls.push("replaceWithSequence"); if (alphabetical) throw new Error("alphabetical"); this._take(file, true); }
}
class CompItem extends Item {
    constructor(name, width, height, aspect, duration, rate) {
        super(name);
        if (!(width >= 4 && width <= 30000 && rate >= 1 && rate <= 99 && duration > 0 && duration <= 10800)) throw new Error("After Effects: impossible comp");
        Object.assign(this, { width, height, duration, frameRate: rate, all: [], markerProperty: new Property("ADBE Marker", null), viewed: 0 });
        this._start = 0; this._length = duration;
        const comp = this;
        this.layers = {
            add(item) { const made = new Layer(comp, item, comp.duration); comp.all.unshift(made); return made; },
            addNull(duration) { const made = new Layer(comp, null, duration); comp.all.unshift(made); return made; },
            addSolid(color, name, width, height, aspect, duration) {
                const solid = new FolderItem(name); solid.color = color; solid.mainSource = { isStill: true };
                const made = new Layer(comp, solid, duration); comp.all.unshift(made); return made;
            }
        };
    }
    set workAreaStart(value) {
        if (!(value >= 0 && value < this.duration)) throw new Error("After Effects: impossible work area start " + value);
        this._start = value;
    }
    set workAreaDuration(value) {
        if (!(value > 0 && this._start + value <= this.duration + 1e-9)) throw new Error("After Effects: impossible work area " + value);
        this._length = value;
    }
    get numLayers() { return this.all.length; }
    layer(index) {
        if (!(index >= 1 && index <= this.all.length)) throw new Error("After Effects: no layer " + index);
        return this.all[index - 1];
    }
    get selectedLayers() { return this.all.filter((layer) => layer.selected); }
    openInViewer() { this.viewed += 1; }
}

const project = { all: [], rootFolder: { name: "root" }, activeItem: null, file: null };
Object.assign(project, {
    get numItems() { return project.all.length; },
    item(index) { return project.all[index - 1]; },
    items: { addFolder: (name) => new FolderItem(name), addComp: (...words) => new CompItem(...words) },
    importFile(options) { calls.push("importFile"); return new FootageItem(options.file, options.sequence); }
});
Object.defineProperty(project, "numItems", { get: () => project.all.length });

class File {
    constructor(written) {
        /* A path may be written as a URI. */
        const name = written.replace(/(%[0-9a-fA-F]{2})+/g, (escape) => decodeURIComponent(escape));
        this.fsName = path.resolve(name); this.name = path.basename(name); this.displayName = this.name;
    }
    get exists() { return fs.existsSync(this.fsName); }
    get parent() { return { fsName: path.dirname(this.fsName) }; }
    open(mode) { this.text = ""; return mode === "w" && settings.mayWrite; }
    write(text) { this.text += text; }
    close() { fs.writeFileSync(this.fsName, this.text); }
    remove() { fs.unlinkSync(this.fsName); }
}
File.saveDialog = () => new File(settings.saveTo);
File.openDialog = () => (settings.openFile ? new File(settings.openFile) : null);
const settings = { saveTo: "", openFile: "", mayWrite: true };
const asked = [];
const BlendingMode = { NORMAL: "NORMAL", MULTIPLY: "MULTIPLY", LIGHTEN: "LIGHTEN" };

const world = {
    app: {
        isoLanguage: "ja_JP", project, newProject() {}, beginUndoGroup() { undo.open += 1; undo.groups += 1; }, endUndoGroup() { undo.open -= 1; },
        settings: { kept: {}, haveSetting(s, n) { return n in this.kept; }, getSetting(s, n) { return this.kept[n]; }, saveSetting(s, n, v) { this.kept[n] = v; } }
    },
    File, Folder: { temp: { fsName: require("os").tmpdir() } }, CompItem, BlendingMode, ImportAsType: { FOOTAGE: "FOOTAGE" }, alert: (words) => alerts.push(words),
    AlphaMode: { STRAIGHT: "STRAIGHT", PREMULTIPLIED: "PREMULTIPLIED", IGNORE: "IGNORE" },
    AutoOrientType: { NO_AUTO_ORIENT: "NO", ALONG_PATH: "PATH" },
    KeyframeInterpolationType: { HOLD: "HOLD", LINEAR: "LINEAR", BEZIER: "BEZIER" },
    ImportOptions: function (file) { this.file = file; this.canImportAs = () => true; },
    KeyframeEase: function (speed, influence) {
        if (!(influence >= 0.1 && influence <= 100)) throw new Error("After Effects: an influence of " + influence);
        this.speed = speed; this.influence = influence;
    },
    MarkerValue: function (comment) { this.comment = comment; this.duration = 0; this.cuePointName = ""; },
    asked, settings, disk: fs, answer: true, confirm(words) { asked.push(words); return world.answer; },
    $: { fileName: path.resolve(scriptPath), global: {}, os: "Macintosh OS", evalFile: (file) => runFile(file.fsName) },
    system: { callSystem: (line) => { if (!settings.mayWrite) throw new Error("After Effects: scripts may not"); calls.push(line); return require("child_process").execSync(line, { encoding: "utf8", shell: "/bin/sh" }); } },
    Panel: class {}, Window: class {
        constructor() { this.buttons = []; this.layout = { layout() {}, resize() {} }; world.panel = world.panel || this; }
        add(kind, bounds, text, most) {
            const made = kind === "progressbar" ? { value: text, most } : { text };
            this.buttons.push(made);
            return made;
        }
        center() {} show() { calls.push("show"); } close() { calls.push("close"); }
        update() { calls.push("at " + this.buttons[0].value + " of " + this.buttons[0].most); }
    }
};
vm.createContext(world);
function runFile(file) {
    const before = world.$.fileName;
    world.$.fileName = path.resolve(file);
    vm.runInContext(fs.readFileSync(file, "utf8"), world, { filename: file });
    world.$.fileName = before;
}

if (mode === "panel") {
    /* The panel beside a comp "cut"; what a user does with it is told in JavaScript. */
    const [, , , , , , saveTo, program, script] = process.argv;
    settings.saveTo = saveTo;
    world.app.settings.kept.program = program;
    world.newComp = (name, frames) => {
        const comp = new CompItem(name, 320, 240, 1, frames / 24, 24);
        comp.put = (file, called) => {
            const layer = comp.layers.add(new FootageItem(new File(file), true));
            layer.name = called; layer.source.mainSource.conformFrameRate = 24; layer.startTime = 0;
            return layer;
        };
        project.activeItem = comp;
        return comp;
    };
    runFile(scriptPath);
    world.press = (index) => world.panel.buttons[index].onClick();
    vm.runInContext(script, world);
} else if (mode === "edited") {
    const steps = process.argv.slice(6);
    runFile(scriptPath);
    for (let i = 0; i < steps.length; i += 2) {
        vm.runInContext(steps[i], world);
        runFile(steps[i + 1]);
    }
} else {
    for (let i = 0; i < Number(times); i++) runFile(scriptPath);
}

fs.writeFileSync(outPath, JSON.stringify({
    alerts, calls, undo, asked,
    items: project.all.map((item) => ({
        kind: item.constructor.name, name: item.name, comment: item.comment, folder: item.parentFolder ? item.parentFolder.name : null,
        file: item.mainSource && item.mainSource.file ? item.mainSource.file.fsName : null, frames: item.frames,
        rate: item.mainSource ? item.mainSource.rate : null, alpha: item.mainSource ? item.mainSource.alphaMode : null,
        width: item.width, height: item.height, duration: item.duration, frameRate: item.frameRate,
        workArea: item.all ? [item._start, item._length] : null, markers: item.markerProperty ? item.markerProperty.keys : null,
        layers: item.all ? item.all.map((layer) => layer.dump()) : null
    }))
}));
