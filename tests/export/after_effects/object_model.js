/* As much of After Effects' object model as the scripts use, with its rules: keys on whole comp times, one blend mode a
   layer, comments that go where their layers go, folders, and what a user does with all of it. */
"use strict";
const fs = require("fs");
const path = require("path");
const vm = require("vm");

const calls = [];
/* How a comp takes its layers along when a script makes it larger is written nowhere; both are tried. */
const settings = { saveTo: "", openFile: "", mayWrite: true, resizeKeeps: "corner", roundsRates: false, refusesWorkArea: false };
const BlendingMode = { NORMAL: "NORMAL", MULTIPLY: "MULTIPLY", LIGHTEN: "LIGHTEN", SCREEN: "SCREEN", ADD: "ADD" };
/* The project that is open, and how many items there ever were. */
const open = { project: null, ids: 0 };

function fail(words) { throw new Error("After Effects: " + words); }

class Property {
    constructor(matchName, value, layer) {
        this.matchName = matchName; this._name = matchName; this._value = value; this.layer = layer || null;
        this.keys = []; this.children = {}; this.expression = ""; this.group = null; this.enabled = true;
        this.isSpatial = ["ADBE Position", "ADBE Anchor Point", "ADBE Geometry2-0001", "ADBE Geometry2-0002", "ADBE Point Control-0001"].includes(matchName);
        /* Scale has a third number in flat layers too; a place has one ease for all of its numbers. */
        this.eases = matchName === "ADBE Scale" ? 3 : 1;
        this._separated = false;
    }
    get name() { return this._name; }
    set name(wanted) {
        if (this.group) {
            const renamed = {};
            for (const [name, child] of Object.entries(this.group.children)) renamed[child === this ? wanted : name] = child;
            this.group.children = renamed;
        }
        this._name = wanted;
    }
    put(child) { child.group = this; child.layer = this.layer; this.children[child.name] = child; return child; }
    get numKeys() { return this.keys.length; }
    /* With an expression the value is what comes of it, as in After Effects. */
    get value() { return this.expression ? this._driven(0) : this._value; }
    set value(value) { this._value = value; }
    get expressionEnabled() { return this.expression !== ""; }
    get dimensionsSeparated() { return this._separated; }
    set dimensionsSeparated(on) {
        const parts = this.group.children;
        if (on && !this._separated) [0, 1].forEach((i) => { parts["ADBE Position_" + i]._value = this._value[i]; });
        this._separated = on;
    }
    _open() {
        if (this.layer) this.layer._unlocked();
        const place = this.group && this.group.children["ADBE Position"];
        const isShut = place && (this === place ? place._separated : /^ADBE Position_/.test(this.matchName) && !place._separated);
        if (isShut) fail("hidden by the dimensions: " + this.matchName);
    }
    _checked(value) { for (const part of [].concat(value)) if (typeof part === "number" && !Number.isFinite(part)) fail("a value is no number"); }
    setValue(value) {
        if (this.keys.length) fail("a value is set although there are keys: " + this.matchName);
        this._open(); this._checked(value);
        this._value = value;
    }
    setValueAtTime(time, value) { this.setValuesAtTimes([time], [value]); }
    setValuesAtTimes(list, values) {
        this._open();
        if (list.length !== values.length) fail("times and values differ in number");
        list.forEach((time, i) => {
            if (!Number.isFinite(time)) fail("a time is no number");
            this._checked(values[i]);
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
    keyInSpatialTangent(index) { this._key(index); if (!this.isSpatial) fail("no tangents"); return new Array(this._directions()).fill(0); }
    _directions() { return /^ADBE (Position|Anchor Point)$/.test(this.matchName) ? 3 : 2; }
    setSpatialAutoBezierAtKey(index, on) { this._key(index).is_curved = on; }
    setSpatialTangentsAtKey(index, into, out) {
        if (!this.isSpatial || into.length !== this._directions() || out.length !== this._directions()) fail("tangents of other directions");
        this._key(index).is_curved = into.concat(out).some((each) => each !== 0);
    }
    valueAtTime(time, isBefore) {
        if (this.expression && !isBefore) return this._driven(time);
        let found = this.keys.length ? this.keys[0].value : this._value;
        this.keys.forEach((key, i) => {
            if (key.time > time + 1e-9) return;
            const next = this.keys[i + 1];
            found = next && (key.out === "LINEAR" || key.out === "BEZIER") && next.time > time ? between(key, next, time) : key.value;
        });
        return found;
    }
    /* The language of expressions is JavaScript; these are the words of it that the scripts use. */
    _driven(time) {
        const comp = this.layer.comp;
        const words = {
            value: this.valueAtTime(time, true), time,
            thisComp: compWords(comp, time), comp: (name) => compWords(named(project().all.filter((each) => each instanceof CompItem), name), time),
            effect: (name) => effectWords(this.layer, name, time)
        };
        return vm.runInNewContext(this.expression, words);
    }
    canAddToMotionGraphicsTemplate() { return true; }
    addToMotionGraphicsTemplateAs(comp, name) { comp.graphics.push(name); return true; }
    removeKey(index) {
        this._key(index);
        if (this.matchName === "ADBE Time Remapping" && this.keys.length === 1) fail("the last key of time remapping");
        this.keys.splice(index - 1, 1);
    }
    nearestKeyIndex(time) {
        let best = 0;
        this.keys.forEach((key, i) => { if (Math.abs(key.time - time) < Math.abs(this.keys[best].time - time)) best = i; });
        return best + 1;
    }
    setTemporalEaseAtKey(index, into, out) {
        if (into.length !== this.eases || out.length !== this.eases) fail("one ease a dimension");
        const key = this._key(index);
        Object.assign(key, { ease_in: this.eases > 1 ? into : into[0], ease_out: this.eases > 1 ? out : out[0], into: "BEZIER", out: "BEZIER" });
    }
    setInterpolationTypeAtKey(index, into, out) {
        const key = this._key(index);
        if (into === undefined || out === undefined) fail("no such interpolation");
        key.into = into; key.out = out;
    }
    _key(index) {
        if (!(index >= 1 && index <= this.keys.length)) fail("no key " + index);
        return this.keys[index - 1];
    }
    property(name) {
        const found = typeof name === "number" ? Object.values(this.children)[name - 1] : this.children[name];
        return found === undefined ? null : found;
    }
    get numProperties() { return Object.keys(this.children).length; }
    remove() { delete this.group.children[this.name]; }
    dump(rate, frames) {
        const children = {};
        for (const [name, child] of Object.entries(this.children)) children[name] = child.dump(rate, frames);
        const made = { matchName: this.matchName, value: this._value, keys: this.keys, separated: this.dimensionsSeparated, children };
        if (this.expression) {
            made.expression = this.expression;
            made.driven = { rate, values: Array.from({ length: frames }, (_, frame) => this._driven(frame / rate)) };
        }
        return made;
    }
}

/* Between two keys, as After Effects has it: speed in units a second, influence in per cent of the gap. */
function between(key, next, time) {
    const gap = next.time - key.time;
    const part = (time - key.time) / gap;
    const along = (start, end, out, into) => {
        if (key.out === "LINEAR" && next.into === "LINEAR") return start + (end - start) * part;
        const x1 = out.influence / 100, x2 = 1 - into.influence / 100;
        const y1 = start + out.speed * gap * x1, y2 = end - into.speed * gap * (1 - x2);
        let low = 0, high = 1;
        for (let i = 0; i < 80; i++) {
            const u = (low + high) / 2;
            if (3 * (1 - u) ** 2 * u * x1 + 3 * (1 - u) * u ** 2 * x2 + u ** 3 < part) low = u; else high = u;
        }
        const u = (low + high) / 2;
        return (1 - u) ** 3 * start + 3 * (1 - u) ** 2 * u * y1 + 3 * (1 - u) * u ** 2 * y2 + u ** 3 * end;
    };
    const plain = { speed: 0, influence: 16.666666667 };
    const ease = (eases, n) => (Array.isArray(eases) ? eases[n] : eases) || plain;
    if (!Array.isArray(key.value)) return along(key.value, next.value, ease(key.ease_out, 0), ease(next.ease_in, 0));
    return key.value.map((each, n) => along(each, next.value[n], ease(key.ease_out, n), ease(next.ease_in, n)));
}

function named(list, name) {
    const found = list.find((each) => each.name === name);
    if (!found) fail("an expression finds no " + name);
    return found;
}
function compWords(comp, time) { return { layer: (name) => ({ effect: (called) => effectWords(named(comp.all, name), called, time) }) }; }
function effectWords(layer, name, time) {
    const effect = named(Object.values(layer._groups["ADBE Effect Parade"].children), name);
    return (part) => ({ value: effect.property(part).valueAtTime(time, false) });
}

const EFFECTS = {
    "ADBE Slider Control": { "0001": 0 }, "ADBE Color Control": { "0001": [1, 0, 0, 1] }, "ADBE Point Control": { "0001": [0, 0] },
    "ADBE Invert": {}, "ADBE Tint": { "0001": [0, 0, 0, 1], "0002": [1, 1, 1, 1], "0003": 100 },
    "ADBE Shift Channels": { "0001": 1, "0002": 2, "0003": 3, "0004": 4 }, "ADBE Fill": { "0001": 0, "0002": [1, 0, 0, 1] },
    "ADBE Gaussian Blur 2": { "0001": 0, "0002": 1, "0003": 0 },
    "ADBE Geometry2": { "0001": "middle", "0002": "middle", "0011": 1, "0003": 100, "0004": 100, "0005": 0, "0006": 0, "0007": 0, "0008": 100, "0009": 1, "0010": 0, "0012": 1 }
};

class Effects extends Property {
    canAddProperty(matchName) { return matchName in EFFECTS; }
    addProperty(matchName) {
        if (!(matchName in EFFECTS)) fail("no effect " + matchName);
        const effect = new Property(matchName, null, this.layer);
        for (let number = 2; effect.name in this.children; number++) effect._name = `${matchName} ${number}`;
        for (const [number, value] of Object.entries(EFFECTS[matchName])) {
            const source = this.layer.source;
            effect.put(new Property(`${matchName}-${number}`, value === "middle" ? [source.width / 2, source.height / 2] : value, this.layer));
        }
        return this.put(effect);
    }
}

class Layer {
    constructor(comp, source, duration) {
        this.id = ++open.ids;
        this.comp = comp; this.source = source; this.name = source.name; this.comment = "";
        this.enabled = true; this.stretch = 100; this.selected = false;
        this._parent = null; this.threeDLayer = false; this.hasTrackMatte = false; this.autoOrient = "NO"; this.nullLayer = false;
        this._start = 5; this._in = 0; this._out = duration; this._remap = false; this.locked = false; this._label = 5; this._blend = BlendingMode.NORMAL;
        this._groups = {
            "ADBE Transform Group": new Property("ADBE Transform Group", undefined, this),
            "ADBE Effect Parade": new Effects("ADBE Effect Parade", undefined, this),
            "ADBE Marker": new Property("ADBE Marker", null, this),
            "ADBE Mask Parade": new Property("ADBE Mask Parade", undefined, this),
            "ADBE Time Remapping": new Property("ADBE Time Remapping", 0, this)
        };
        const middle = source.width ? [source.width / 2, source.height / 2] : [0, 0];
        const usual = [["ADBE Opacity", 100], ["ADBE Anchor Point", middle], ["ADBE Scale", [100, 100]], ["ADBE Rotate Z", 0],
            ["ADBE Position_0", 0], ["ADBE Position_1", 0], ["ADBE Position", [comp.width / 2, comp.height / 2]]];
        for (const [name, value] of usual) this._groups["ADBE Transform Group"].put(new Property(name, value, this));
    }
    /* Whether a script may change a locked layer is written nowhere; here it may not. */
    _unlocked() { if (this.locked) fail("the layer is locked: " + this.name); }
    get startTime() { return this._start; }
    set startTime(value) { this._unlocked(); this._start = value; }
    get inPoint() { return this._in; }
    set inPoint(value) { this._unlocked(); this._in = value; }
    get outPoint() { return this._out; }
    set outPoint(value) { this._unlocked(); this._out = value; }
    get label() { return this._label; }
    set label(value) { this._unlocked(); this._label = value; }
    get blendingMode() { return this._blend; }
    set blendingMode(value) { this._unlocked(); this._blend = value; }
    get transform() { return this._groups["ADBE Transform Group"].children; }
    get index() { return this.comp.all.indexOf(this) + 1; }
    get containingComp() { return this.comp; }
    get canSetTimeRemapEnabled() { return !(this.source.mainSource && this.source.mainSource.isStill); }
    get timeRemapEnabled() { return this._remap; }
    set timeRemapEnabled(on) {
        const property = this._groups["ADBE Time Remapping"];
        if (on && !this._remap) property.setValuesAtTimes([0, this.source.duration], [0, this.source.duration]);
        if (!on) property.keys = [];
        this._remap = on;
    }
    get parent() { return this._parent; }
    /* A layer stays where it is seen, so its own numbers change. */
    set parent(other) {
        if (this._parent) this._carry(matrixOf(this._parent), this._parent);
        if (other) this._carry(inverse(matrixOf(other)), other, true);
        this._parent = other;
    }
    _carry(matrix, other, isInto) {
        const place = this.transform["ADBE Position"];
        const moved = ([x, y]) => [matrix[0] * x + matrix[2] * y + matrix[4], matrix[1] * x + matrix[3] * y + matrix[5]];
        if (place.dimensionsSeparated) {
            const parts = [0, 1].map((i) => this.transform["ADBE Position_" + i]);
            const at = moved(parts.map((each) => each._value));
            parts.forEach((each, i) => { each._value = at[i]; });
        }
        place._value = moved(place._value);
        place.keys.forEach((key) => { key.value = moved(key.value); });
        this.transform["ADBE Rotate Z"]._value += (isInto ? -1 : 1) * other.transform["ADBE Rotate Z"]._value;
        const scale = this.transform["ADBE Scale"];
        scale._value = scale._value.map((each, i) => each * (other.transform["ADBE Scale"]._value[i] / 100) ** (isInto ? -1 : 1));
    }
    property(name) {
        if (!(name in this._groups)) fail("no property " + name);
        return this._groups[name];
    }
    _move(other, by) {
        this._unlocked();
        if (!(other instanceof Layer) || other === this || other.comp !== this.comp) fail("a layer is moved to no other of its comp");
        this.comp.all.splice(this.comp.all.indexOf(this), 1);
        this.comp.all.splice(this.comp.all.indexOf(other) + by, 0, this);
    }
    moveAfter(other) { this._move(other, 1); }
    moveBefore(other) { this._move(other, 0); }
    moveToEnd() { this.comp.all.splice(this.comp.all.indexOf(this), 1); this.comp.all.push(this); }
    moveToBeginning() { this.comp.all.splice(this.comp.all.indexOf(this), 1); this.comp.all.unshift(this); }
    remove() {
        this.comp.all.forEach((each) => { if (each._parent === this) each.parent = null; });
        this.comp.all.splice(this.comp.all.indexOf(this), 1);
    }
    replaceSource(item) { this.source = item; }
    /* Above the one it is a copy of, with its comment and its number as its name has it. */
    duplicate() {
        const copy = cloned(this, [this.comp, this.source, this._parent]);
        copy.id = ++open.ids;
        this.comp.all.splice(this.comp.all.indexOf(this), 0, copy);
        return copy;
    }
    split(time) {
        const later = this.duplicate();
        this.outPoint = time; later.inPoint = time;
        return later;
    }
    moveToComp(comp) {
        this.comp.all.splice(this.comp.all.indexOf(this), 1);
        this.comp = comp; comp.all.unshift(this);
    }
    dump() {
        const groups = {};
        for (const [name, group] of Object.entries(this._groups)) groups[name] = group.dump(this.comp.frameRate, Math.round(this.comp.duration * this.comp.frameRate));
        return {
            name: this.name, comment: this.comment, blend: this.blendingMode, enabled: this.enabled, inPoint: this.inPoint, label: this.label,
            outPoint: this.outPoint, startTime: this.startTime, source: this.source.name, source_id: this.source.id, remap: this._remap,
            parent: this._parent ? this._parent.name : null, groups
        };
    }
}

/* [a, b, c, d, x, y]: x of the parent is a x + c y + x. */
function matrixOf(layer) {
    const at = layer.transform, turn = at["ADBE Rotate Z"]._value * Math.PI / 180;
    const [sx, sy] = at["ADBE Scale"]._value.map((each) => each / 100), [ax, ay] = at["ADBE Anchor Point"]._value;
    const [px, py] = at["ADBE Position"].dimensionsSeparated ? [at["ADBE Position_0"]._value, at["ADBE Position_1"]._value] : at["ADBE Position"]._value;
    const a = Math.cos(turn) * sx, b = Math.sin(turn) * sx, c = -Math.sin(turn) * sy, d = Math.cos(turn) * sy;
    const own = [a, b, c, d, px - a * ax - c * ay, py - b * ax - d * ay];
    return layer._parent ? product(matrixOf(layer._parent), own) : own;
}
function product(m, n) {
    return [m[0] * n[0] + m[2] * n[1], m[1] * n[0] + m[3] * n[1], m[0] * n[2] + m[2] * n[3], m[1] * n[2] + m[3] * n[3],
        m[0] * n[4] + m[2] * n[5] + m[4], m[1] * n[4] + m[3] * n[5] + m[5]];
}
function inverse([a, b, c, d, x, y]) {
    const det = a * d - b * c;
    return [d / det, -b / det, -c / det, a / det, (c * y - d * x) / det, (b * x - a * y) / det];
}

class Item {
    constructor(name) { this.id = ++open.ids; this.name = name; this.comment = ""; this.label = 0; this.parentFolder = project().rootFolder; project().all.push(this); }
    remove() {
        const all = project().all;
        if (!all.includes(this)) fail("the item is gone");
        all.splice(all.indexOf(this), 1);
        for (const item of all.slice()) {
            if (item.all) for (const layer of item.all.slice()) if (layer.source === this) layer.remove();
            if (item.parentFolder === this && all.includes(item)) item.remove();
        }
    }
    get usedIn() { return project().all.filter((each) => each instanceof CompItem && each.all.some((layer) => layer.source === this)); }
}
class FolderItem extends Item {
    get numItems() { return project().all.filter((each) => each.parentFolder === this).length; }
}
class FootageItem extends Item {
    constructor(file, sequence) { super(file.name); this._take(file, sequence); }
    _take(file, sequence) {
        if (!file.exists) fail("no such file: " + file.fsName);
        const head = Buffer.alloc(24);
        const opened = fs.openSync(file.fsName, "r"); fs.readSync(opened, head, 0, 24, 0); fs.closeSync(opened);
        const isPng = head.toString("latin1", 1, 4) === "PNG";
        this.width = isPng ? head.readUInt32BE(16) : 4; this.height = isPng ? head.readUInt32BE(20) : 4;
        /* The rules of interpretation may take an odd size for oblong pixels. */
        this.pixelAspect = this.width === 720 ? 1.0667 : 1;
        /* How a file is interpreted stays when another takes its place. */
        const before = this.mainSource;
        this.mainSource = new FileSource(this, file, sequence ? framesOf(file) : 1, !sequence);
        this.frames = this.mainSource.frames;
        this.duration = sequence ? this.frames / 30 : 0;
        if (!before) return;
        Object.assign(this.mainSource, { alphaMode: before.alphaMode, premulColor: before.premulColor });
        if (sequence && before.isConformed) this.mainSource.conformFrameRate = before.rate;
    }
    get footageMissing() { return !this.mainSource.file.exists; }
    replace(file) { calls.push("replace"); this._take(file, false); }
    replaceWithSequence(file, alphabetical) { calls.push("replaceWithSequence"); if (alphabetical) fail("alphabetical"); this._take(file, true); }
}
function framesOf(file) {
    const parts = /^(.*?)(\d+)(\.\w+)$/.exec(path.basename(file.fsName));
    const all = fs.readdirSync(path.dirname(file.fsName)).filter((each) => {
        const found = /^(.*?)(\d+)(\.\w+)$/.exec(each);
        return found && found[1] === parts[1] && found[3] === parts[3];
    }).sort();
    all.forEach((each, i) => { if (Number(/(\d+)\.\w+$/.exec(each)[1]) !== Number(parts[2]) + i) fail("a gap in the sequence " + file.fsName); });
    return all.length;
}
class FileSource {
    constructor(item, file, frames, isStill) {
        Object.assign(this, { item, file, frames, isStill, hasAlpha: true, alphaMode: null, premulColor: null, rate: 30, isConformed: false });
    }
    get conformFrameRate() { return this.isConformed ? this.rate : 0; }
    get displayFrameRate() { return this.rate; }
    set conformFrameRate(rate) {
        if (this.isStill) fail("a still has no frame rate");
        this.rate = rate; this.isConformed = true; this.item.duration = this.frames / rate;
    }
}
/* Nulls and solids have a source, which lies in a folder that After Effects makes for them. */
class SolidItem extends Item {
    constructor(name, width, height) {
        super(name);
        Object.assign(this, { width, height, pixelAspect: 1, duration: 0, mainSource: { isStill: true, file: null } });
        const folder = project().all.find((each) => each instanceof FolderItem && each.isOfSolids) || new FolderItem("Solids");
        folder.isOfSolids = true;
        this.parentFolder = folder;
    }
}

class Layers {
    constructor(comp) { this.comp = comp; }
    _added(source, duration) { const made = new Layer(this.comp, source, duration); this.comp.all.unshift(made); return made; }
    add(item) { return this._added(item, this.comp.duration); }
    addNull(duration) {
        const made = this._added(new SolidItem("Null 1", 100, 100), duration);
        made.nullLayer = true; made.transform["ADBE Anchor Point"]._value = [0, 0]; made.startTime = 0;
        return made;
    }
    addSolid(color, name, width, height, aspect, duration) {
        const solid = new SolidItem(name, width, height); solid.color = color;
        return this._added(solid, duration);
    }
    precompose(indices, name, movesAll) {
        const comp = this.comp;
        const taken = indices.map((index) => comp.layer(index));
        if (!movesAll && taken.length !== 1) fail("attributes are left for one layer only");
        const source = taken[0].source;
        const within = movesAll ? new CompItem(name, comp.width, comp.height, 1, comp.duration, comp.frameRate)
            : new CompItem(name, source.width, source.height, 1, source.duration || comp.duration, comp.frameRate);
        within.parentFolder = comp.parentFolder;
        if (!movesAll) {
            /* The layer stays with all it has, and shows the new composition. */
            within.layers.add(source).startTime = 0;
            taken[0].source = within;
            return within;
        }
        const top = Math.min(...indices) - 1;
        taken.forEach((layer) => {
            if (layer._parent && !taken.includes(layer._parent)) layer.parent = null;
            comp.all.splice(comp.all.indexOf(layer), 1); layer.comp = within; within.all.push(layer);
        });
        const outer = new Layer(comp, within, comp.duration);
        outer.startTime = 0;
        comp.all.splice(top, 0, outer);
        return within;
    }
}
class CompItem extends Item {
    constructor(name, width, height, aspect, duration, rate) {
        super(name);
        if (!(width >= 4 && width <= 30000 && rate >= 1 && rate <= 99 && duration > 0 && duration <= 10800)) fail("impossible comp");
        Object.assign(this, {
            _width: width, _height: height, _duration: duration, _rate: rate, pixelAspect: aspect, all: [], viewed: 0, graphics: [],
            motionGraphicsTemplateName: "Untitled", markerProperty: new Property("ADBE Marker", null), displayStartTime: 0, displayStartFrame: 0, _start: 0, _length: duration
        });
        this.layers = new Layers(this);
    }
    get width() { return this._width; }
    set width(value) { this._resize(value, this._height); }
    get height() { return this._height; }
    set height(value) { this._resize(this._width, value); }
    _resize(width, height) {
        if (settings.resizeKeeps === "middle") this._shift((width - this._width) / 2, (height - this._height) / 2);
        this._width = width; this._height = height;
    }
    _shift(x, y) {
        for (const layer of this.all) {
            if (layer._parent) continue;
            const place = layer.transform["ADBE Position"];
            place._value = [place._value[0] + x, place._value[1] + y];
            place.keys.forEach((key) => { key.value = [key.value[0] + x, key.value[1] + y]; });
            [x, y].forEach((by, i) => {
                const part = layer.transform["ADBE Position_" + i];
                part._value += by;
                part.keys.forEach((key) => { key.value += by; });
            });
        }
    }
    /* The dialog of a composition's settings has an anchor, which is the middle unless one says otherwise. */
    setByHand(width, height, across, down) {
        this._shift((width - this._width) * across, (height - this._height) * down);
        this._width = width; this._height = height;
    }
    get frameRate() { return this._rate; }
    set frameRate(rate) { if (!(rate >= 1 && rate <= 99)) fail("impossible rate " + rate); this._rate = settings.roundsRates ? Math.round(rate) : rate; }
    get frameDuration() { return 1 / this._rate; }
    get duration() { return this._duration; }
    set duration(value) {
        if (!(value > 0 && value <= 10800)) fail("impossible duration " + value);
        this._duration = value;
        this._start = Math.min(this._start, value - 1 / this._rate); this._length = Math.min(this._length, value - this._start);
    }
    get workAreaStart() { return this._start; }
    set workAreaStart(value) {
        if (settings.refusesWorkArea || !(value >= 0 && value < this.duration)) fail("impossible work area start " + value);
        this._start = value; this._length = Math.min(this._length, this.duration - value);
    }
    get workAreaDuration() { return this._length; }
    set workAreaDuration(value) {
        if (!(value > 0 && this._start + value <= this.duration + 1e-9)) fail("impossible work area " + value);
        this._length = value;
    }
    get numLayers() { return this.all.length; }
    layer(index) {
        if (!(index >= 1 && index <= this.all.length)) fail("no layer " + index);
        return this.all[index - 1];
    }
    get selectedLayers() { return this.all.filter((layer) => layer.selected); }
    openInViewer() { this.viewed += 1; }
    /* With the same comment, and layers that show the same items. */
    duplicate() {
        const copy = cloned(this, project().all.filter((each) => each !== this).concat([project().rootFolder]));
        copy.id = ++open.ids; copy.name = this.name + " 2";
        project().all.push(copy);
        return copy;
    }
}

class Project {
    constructor() {
        this.all = []; this.rootFolder = { name: "root" }; this.activeItem = null; this.file = null;
        this.linearBlending = false; this.linearizeWorkingSpace = false; this.workingSpace = ""; this.bitsPerChannel = 8;
    }
    get numItems() { return this.all.length; }
    item(index) { return this.all[index - 1]; }
    get items() { return { addFolder: (name) => new FolderItem(name), addComp: (...words) => new CompItem(...words) }; }
    importFile(options) { calls.push("importFile"); return new FootageItem(options.file, options.sequence); }
}
function project() { return open.project; }
open.project = new Project();

/* A copy of everything that can be reached, but for what is kept as it is. */
function cloned(value, kept) {
    const made = new Map((kept || []).filter((each) => each !== null).map((each) => [each, each]));
    const copyOf = (each) => {
        if (each === null || typeof each !== "object") return each;
        if (made.has(each)) return made.get(each);
        const copy = Array.isArray(each) ? [] : Object.create(Object.getPrototypeOf(each));
        made.set(each, copy);
        for (const name of Object.keys(each)) copy[name] = copyOf(each[name]);
        return copy;
    };
    return copyOf(value);
}

/* Undo groups may lie in one another; the outermost is one step. */
const undo = { open: 0, groups: 0, states: [] };
const history = {
    begin() { if (undo.open++ === 0) { undo.groups += 1; undo.states.push(cloned(open.project)); } },
    end() { undo.open -= 1; },
    undo() { open.project = undo.states.pop(); }
};

/* Another project file brought into this one: all in a folder, with other numbers. */
function bringIn(other) {
    const copy = cloned(other);
    const folder = new FolderItem("cut.aep");
    for (const item of copy.all) {
        item.id = ++open.ids;
        if (item.parentFolder === copy.rootFolder) item.parentFolder = folder;
        project().all.push(item);
    }
}

module.exports = { Project, CompItem, FolderItem, FootageItem, Layer, Property, BlendingMode, calls, settings, open, project, cloned, undo, history, bringIn };
