/* After Effects as its scripts see it. node fake_after_effects.js OUT TIMES SCRIPT runs SCRIPT so many times and writes what
   is there as JSON; with "edited" and then pairs EDIT SCRIPT it runs what a user does in between and then each further SCRIPT. */
"use strict";
const fs = require("fs");
const path = require("path");
const vm = require("vm");
const model = require("./object_model.js");

const [, , outPath, times, scriptPath, mode] = process.argv;
const { CompItem, FolderItem, FootageItem, BlendingMode, calls, settings, undo, project } = model;
const alerts = [];

class File {
    constructor(written) {
        /* A path may be written as a URI. */
        const name = written.replace(/(%[0-9a-fA-F]{2})+/g, (escape) => decodeURIComponent(escape));
        this.fsName = path.resolve(name); this.name = path.basename(name); this.displayName = this.name;
    }
    get exists() { return fs.existsSync(this.fsName); }
    get parent() { return { fsName: path.dirname(this.fsName) }; }
    open(mode) { this.text = ""; this.mode = mode; return mode === "w" ? settings.mayWrite : this.exists; }
    write(text) { this.text += text; }
    read() { return fs.readFileSync(this.fsName, "utf8"); }
    close() { if (this.mode === "w") fs.writeFileSync(this.fsName, this.text); }
    remove() { fs.unlinkSync(this.fsName); }
}
File.saveDialog = () => new File(settings.saveTo);
File.openDialog = () => (settings.openFile ? new File(settings.openFile) : null);
const asked = [];
/* What is scheduled runs while After Effects waits for the user, and in its own time. */
const tasks = Object.assign(new Map(), { made: 0 });
const sleep = (ms) => Atomics.wait(new Int32Array(new SharedArrayBuffer(4)), 0, 0, ms);
function tick() {
    for (const [id, task] of [...tasks]) {
        if (!task.repeats) tasks.delete(id);
        vm.runInContext(task.text, world);
    }
}
function settle() { while (tasks.size > 0) { sleep(20); tick(); } }
/* callSystem waits until everyone has let go of its pipe. Windows: PowerShell takes a script in base 64. */
function callSystem(line) {
    if (!settings.mayWrite) throw new Error("After Effects: scripts may not");
    if (/[^\x20-\x7e]/.test(line)) throw new Error("a line that depends on the code page: " + line);
    calls.push(line);
    const started = Date.now();
    const script = /^powershell\.exe .*-EncodedCommand ([A-Za-z0-9+\/=]+)$/.exec(line);
    const said = script ? powerShell(Buffer.from(script[1], "base64").toString("utf16le"))
        : require("child_process").execSync(line, { encoding: "utf8", shell: "/bin/sh", timeout: 60000 });
    settings.waited = Math.max(settings.waited || 0, Date.now() - started);
    return said;
}
function powerShell(script) {
    calls.push(script);
    const words = /^try { Start-Process -FilePath '((?:[^']|'')*)' -ArgumentList '"((?:[^']|'')*)"'( -WindowStyle Hidden)? -ErrorAction Stop } catch { \[Console\]::Out\.Write\('kagezou-failed'\) }$/.exec(script);
    if (!words) throw new Error("no such script: " + script);
    const [program, argument] = [words[1], words[2]].map((word) => word.replace(/(['\u2018\u2019\u201a\u201b])\1/g, "$1"));
    if (!fs.existsSync(program)) return "kagezou-failed";
    require("child_process").spawn(program, [argument], { detached: true, stdio: "ignore" }).unref();
    return "";
}

/* A row of things in a panel, and a list of which one is shown: by its number it is set, and what is read has that number. */
class Row {
    constructor() { this.parts = []; }
    add(kind, bounds, text) { const made = kind === "dropdownlist" ? new DropDown(text) : { text, enabled: true }; this.parts.push(made); return made; }
}
class DropDown {
    constructor(texts) { this.items = texts.map((text, index) => ({ text, index })); this.shown = null; }
    get selection() { return this.shown; }
    set selection(index) { this.shown = index === null ? null : this.items[index]; if (this.onChange) this.onChange(); }
}

const world = {
    app: {
        isoLanguage: "ja_JP", get project() { return project(); }, newProject() { model.open.project = new model.Project(); return project(); },
        openProject(other) { model.open.project = other; }, beginUndoGroup() { model.history.begin(); }, endUndoGroup() { model.history.end(); },
        scheduleTask(text, delay, repeats) { tasks.set(++tasks.made, { text, repeats }); return tasks.made; }, cancelTask(id) { tasks.delete(id); },
        settings: { kept: {}, haveSetting(s, n) { return n in this.kept; }, getSetting(s, n) { return this.kept[n]; }, saveSetting(s, n, v) { this.kept[n] = v; } }
    },
    File, Folder: { temp: { fsName: require("os").tmpdir() }, userData: { fsName: "/nowhere/user" }, appData: { fsName: "/nowhere/all" } }, CompItem, FolderItem, FootageItem, BlendingMode, ImportAsType: { FOOTAGE: "FOOTAGE" }, alert: (words) => alerts.push(words),
    AlphaMode: { STRAIGHT: "STRAIGHT", PREMULTIPLIED: "PREMULTIPLIED", IGNORE: "IGNORE" },
    AutoOrientType: { NO_AUTO_ORIENT: "NO", ALONG_PATH: "PATH" },
    KeyframeInterpolationType: { HOLD: "HOLD", LINEAR: "LINEAR", BEZIER: "BEZIER" },
    ImportOptions: function (file) { this.file = file; this.canImportAs = () => true; },
    KeyframeEase: function (speed, influence) {
        if (!(influence >= 0.1 && influence <= 100)) throw new Error("After Effects: an influence of " + influence);
        this.speed = speed; this.influence = influence;
    },
    MarkerValue: function (comment) { this.comment = comment; this.duration = 0; this.cuePointName = ""; },
    asked, settings, disk: fs, undo: model.history.undo, bringIn: model.bringIn, keyboard: { shiftKey: false },
    ScriptUI: { environment: { get keyboardState() { return world.keyboard; } } }, answer: true, confirm(words) { asked.push(words); return world.answer; },
    isWaiting: () => tasks.size > 0, $: { fileName: path.resolve(scriptPath), global: {}, os: process.env.FAKE_OS || "Macintosh OS", evalFile: (file) => runFile(file.fsName) },
    system: { callSystem }, sleep, tick, settle,
    Panel: class {}, Window: class {
        constructor() { this.buttons = []; this.layout = { layout() {}, resize() {} }; world.panel = world.panel || this; }
        add(kind, bounds, text, most) {
            const made = kind === "progressbar" ? { value: text, most } : (kind === "group" ? new Row() : { text, enabled: true });
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
    world.callProgram = (...words) => require("child_process").execFileSync(program, words, { encoding: "utf8" });
    world.newComp = (name, frames) => {
        const comp = new CompItem(name, 320, 240, 1, frames / 24, 24);
        comp.put = (file, called) => {
            const layer = comp.layers.add(new FootageItem(new File(file), true));
            layer.name = called; layer.source.mainSource.conformFrameRate = 24; layer.startTime = 0;
            return layer;
        };
        project().activeItem = comp;
        return comp;
    };
    world.$.global = world;
    runFile(scriptPath);
    world.click = (index) => world.panel.buttons[index].onClick();
    world.press = (index) => { world.click(index); settle(); };
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
    alerts, calls, asked, undo: { open: undo.open, groups: undo.groups },
    items: project().all.map((item) => ({
        kind: item.constructor.name, id: item.id, name: item.name, comment: item.comment, folder: item.parentFolder ? item.parentFolder.name : null,
        file: item.mainSource && item.mainSource.file ? item.mainSource.file.fsName : null, frames: item.frames, label: item.label,
        rate: item.mainSource ? item.mainSource.rate : null, alpha: item.mainSource ? item.mainSource.alphaMode : null, aspect: item.pixelAspect,
        width: item.width, height: item.height, duration: item.duration, frameRate: item.frameRate, first: item.displayStartFrame,
        workArea: item.all ? [item._start, item._length] : null, markers: item.markerProperty ? item.markerProperty.keys : null,
        graphics: item.graphics || null, layers: item.all ? item.all.map((layer) => layer.dump()) : null
    }))
}));
