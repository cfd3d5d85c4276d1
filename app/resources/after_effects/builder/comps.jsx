    /* Compositions: their settings follow as layers do. Those that the user precomposed follow the one they are in, as long
       as they are of its size, rate and length. */
    var SETTINGS = {
        S: function (comp) {
            return sizeOf(comp);
        },
        P: function (comp) {
            return String(Math.round(comp.pixelAspect * 1000));
        },
        F: function (comp) {
            return String(Math.round(comp.frameRate * 1000));
        },
        D: function (comp) {
            return String(roundedTime(comp.duration));
        },
        N: function (comp) {
            return String(comp.displayStartFrame);
        },
        A: function (comp) {
            return roundedTime(comp.workAreaStart) + "/" + roundedTime(comp.workAreaDuration);
        }
    };
    var WANTED_SETTINGS = {
        S: HAND_OFF.width + "x" + HAND_OFF.height,
        P: "1000",
        F: String(Math.round(HAND_OFF.frame_rate * 1000)),
        D: String(roundedTime(HAND_OFF.duration)),
        N: String(HAND_OFF.first_frame),
        A: roundedTime(HAND_OFF.work_area[0]) + "/" + roundedTime(HAND_OFF.work_area[1])
    };
    var SETTERS = {
        S: function (comp) {
            comp.width = HAND_OFF.width;
            comp.height = HAND_OFF.height;
            origins["$" + comp.id] = [0, 0];
        },
        P: function (comp) {
            comp.pixelAspect = 1;
        },
        F: function (comp) {
            comp.frameRate = HAND_OFF.frame_rate;
            checkRate(comp);
        },
        D: function (comp) {
            comp.duration = HAND_OFF.duration;
        },
        /* Since After Effects 17.1; before that compositions begin at 0. */
        N: function (comp) {
            if (comp.displayStartFrame !== undefined) {
                comp.displayStartFrame = HAND_OFF.first_frame;
            }
        },
        A: setWorkArea
    };
    var ORDER = ["S", "P", "F", "D", "N", "A"];

    /** @param {CompItem} comp */
    function setWorkArea(comp) {
        try {
            comp.workAreaStart = HAND_OFF.work_area[0];
            comp.workAreaDuration = Math.min(HAND_OFF.work_area[1], comp.duration - HAND_OFF.work_area[0]);
        } catch (problem) {
            tellNote(said(WORDS.workArea, [comp.name]));
        }
    }

    /* Rates are kept with few digits: what would be seen by the end of the cut is said. */
    /** @param {CompItem} comp */
    function checkRate(comp) {
        if (Math.abs(comp.frameDuration * HAND_OFF.frame_rate - 1) * HAND_OFF.frames > 0.05) {
            tellNote(said(WORDS.rateDiffers, [comp.name, shortened(1 / comp.frameDuration), shortened(HAND_OFF.frame_rate)]));
        }
    }

    function shortened(number) {
        return Math.round(number * 1000) / 1000;
    }

    /* How compositions are before anything is changed, by their ids. */
    var settingsBefore = {};

    /* What the user added is no business of the script, but it no longer lies on the same part of the picture. */
    function tellOwnLayers(comp, name) {
        for (var i = 1; i <= comp.numLayers && name === "S"; i++) {
            if (readComment(comp.layer(i).comment) === null && !isCarrier(comp.layer(i))) {
                tellNote(said(WORDS.ownLayers, [comp.name]));
                return;
            }
        }
    }

    /** @param {CompItem} comp */
    function measureComp(comp) {
        var states = {};
        for (var i = 0; i < ORDER.length; i++) {
            states[ORDER[i]] = SETTINGS[ORDER[i]](comp);
        }
        settingsBefore["$" + comp.id] = states;
    }

    /** @param {CompItem} comp */
    function before(comp) {
        return settingsBefore["$" + comp.id];
    }

    function isUsers(comp, memory, name) {
        return memory[name] !== undefined && memory[name] !== before(comp)[name] && before(comp)[name] !== WANTED_SETTINGS[name];
    }

    /* Where both sides changed a setting one question is asked about all of them, and not again for the same answer. */
    function askAbout(instances) {
        var lines = [];
        var asked = [];
        for (var i = 0; i < instances.length; i++) {
            var memory = readComment(instances[i].comment).memory;
            for (var j = 0; j < ORDER.length; j++) {
                var name = ORDER[j];
                var isNews = WANTED_SETTINGS[name] !== memory[name] && WANTED_SETTINGS[name] !== memory["d" + name];
                if (isUsers(instances[i], memory, name) && isNews) {
                    lines.push(instances[i].name + ": " + WORDS.aspects[name]);
                    asked.push({ comp: instances[i], memory: memory, name: name });
                }
            }
        }
        var isTaken = lines.length > 0 && confirm(WORDS.settings + lines.join("\n") + WORDS.take);
        for (i = 0; i < asked.length; i++) {
            var now = readComment(asked[i].comp.comment);
            if (isTaken) {
                now.memory[asked[i].name] = before(asked[i].comp)[asked[i].name];
            } else {
                now.memory["d" + asked[i].name] = WANTED_SETTINGS[asked[i].name];
            }
            remember(asked[i].comp, now.tag, now.memory);
        }
    }

    /**
     * @param {CompItem} comp
     * @param {boolean} isNew
     */
    function updateComp(comp, isNew) {
        var read = readComment(comp.comment);
        for (var i = 0; i < ORDER.length; i++) {
            var name = ORDER[i];
            if (!isNew && isUsers(comp, read.memory, name)) {
                tellLeft(comp.name, name);
                continue;
            }
            if (SETTINGS[name](comp) !== WANTED_SETTINGS[name] || isNew) {
                SETTERS[name](comp);
            }
            var now = SETTINGS[name](comp);
            if (!isNew && now !== before(comp)[name]) {
                tellChanged(comp.name, name);
                tellOwnLayers(comp, name);
            }
            read.memory[name] = now;
        }
        read.memory.V = [comp.width, comp.height].concat(originIn(comp)).join("/");
        remember(comp, read.tag, read.memory);
    }

    function addComp(wanted, root) {
        var comp = app.project.items.addComp(wanted.name, HAND_OFF.width, HAND_OFF.height, 1, HAND_OFF.duration, HAND_OFF.frame_rate);
        checkRate(comp);
        comp.parentFolder = root;
        keepItem(comp, coded("comp:" + wanted.tag));
        noteMade(coded("comp:" + wanted.tag));
        comps.push(comp);
        measureComp(comp);
        updateComp(comp, true);
        return comp;
    }
