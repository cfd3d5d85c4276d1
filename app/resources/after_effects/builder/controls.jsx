    /* Controls: one null with sliders that drive all shadows by expressions. At first they change nothing. What the user sets
       on it is never touched, and what it no longer drives is as it was without it. */
    var CONTROLS = [
        { name: "Opacity", effect: "ADBE Slider Control", value: 100 },
        { name: "Color", effect: "ADBE Color Control", value: [0, 0, 0, 1] },
        { name: "Color Amount", effect: "ADBE Slider Control", value: 0 },
        { name: "Softness", effect: "ADBE Slider Control", value: 0 },
        { name: "Height", effect: "ADBE Slider Control", value: 0 }
    ];
    var TINT = "Kagezou Color";
    var BLUR = "Kagezou Softness";
    var MOVE = "Kagezou Height";
    var RAISED = "Kagezou Raised";

    /** @param {CompItem} comp @param {string} tag @param {FolderItem} root */
    function addControls(comp, tag, root) {
        var layer = comp.layers.addNull(HAND_OFF.duration);
        layer.name = freeName(comp, "Kagezou");
        layer.startTime = 0;
        layer.enabled = false;
        moveSource(layer, "Kagezou", folderOf("Guides", root));
        for (var i = 0; i < CONTROLS.length; i++) {
            effectsOf(layer).addProperty(CONTROLS[i].effect).name = CONTROLS[i].name;
            var control = propertyOf(effectsOf(layer).property(CONTROLS[i].name), CONTROLS[i].effect + "-0001");
            control.setValue(/** @type {any} */ (CONTROLS[i].value));
            offer(comp, control, CONTROLS[i].name);
        }
        var entry = newEntry(comp, layer, tag);
        remember(layer, tag, {});
        return entry;
    }

    function freeName(comp, wanted) {
        var taken = "\n";
        for (var i = 1; i <= comp.numLayers; i++) {
            taken += comp.layer(i).name + "\n";
        }
        var name = wanted;
        for (var number = 2; taken.indexOf("\n" + name + "\n") >= 0; number++) {
            name = wanted + " " + number;
        }
        return name;
    }

    /**
     * In Essential Graphics, which After Effects has since CC 2018 for scripts and with names since CC 2019.
     * @param {CompItem} comp
     * @param {Property} property
     * @param {string} name
     */
    function offer(comp, property, name) {
        try {
            if (!property.canAddToMotionGraphicsTemplate || !property.canAddToMotionGraphicsTemplate(comp)) {
                return;
            }
            if (property.addToMotionGraphicsTemplateAs) {
                property.addToMotionGraphicsTemplateAs(comp, WORDS.controls[name]);
            } else {
                property.addToMotionGraphicsTemplate(comp);
            }
        } catch (problem) {
            tellNote(said(WORDS.graphics, [problem.message || problem]));
        }
    }

    /** The null that drives a layer: that of its own composition, else of one that it lies within, else any. */
    function controlOf(entry) {
        var found = entriesOf("controls");
        var best = null;
        for (var i = 0; i < found.length; i++) {
            if (found[i].comp.id === entry.comp.id) {
                return found[i];
            }
            if (best === null || (!holds(best.comp, [entry.comp]) && holds(found[i].comp, [entry.comp]))) {
                best = found[i];
            }
        }
        return best;
    }

    /**
     * @param {Entry} entry
     * @param {any} driven
     */
    function followControls(entry, driven) {
        var control = driven ? controlOf(entry) : null;
        if (!driven || (control === null && entry.memory.x === undefined)) {
            return;
        }
        follow(entry, "x", function () {
            if (control === null) {
                release(entry.layer);
            } else {
                addDriven(entry, driven);
                drive(entry, driven, control);
            }
        });
    }

    function ourEffect(layer, name) {
        return effectsOf(layer).property(name);
    }

    /* Once each; an effect that the user took away never comes again. */
    function addDriven(entry, driven) {
        var had = entry.memory.v || "";
        if (driven.has_look && had.indexOf("L") < 0) {
            addNamed(entry.layer, "ADBE Tint", TINT);
            propertyOf(ourEffect(entry.layer, TINT), "ADBE Tint-0003").setValue(/** @type {any} */ (0));
            addNamed(entry.layer, "ADBE Gaussian Blur 2", BLUR);
            had += "L";
        }
        if (driven.rising && had.indexOf("H") < 0) {
            addNamed(entry.layer, "ADBE Point Control", RAISED);
            addNamed(entry.layer, "ADBE Geometry2", MOVE);
            had += "H";
        }
        entry.memory.v = had;
    }

    function addNamed(layer, effect, name) {
        effectsOf(layer).addProperty(effect).name = name;
    }

    function quoted(text) {
        return "\"" + text.replace(/[\\"]/g, "\\$&").replace(/\r|\n/g, " ") + "\"";
    }

    /* The value of a control as c, wherever the layer is precomposed to. */
    function reading(control, name, as) {
        var way = ".layer(" + quoted(control.layer.name) + ").effect(\"" + name + "\")(1).value;";
        return "var " + as + "; try { " + as + " = thisComp" + way + " } catch (problem) { " + as + " = comp(" + quoted(control.comp.name) + ")" + way + " }\n";
    }

    /**
     * @param {Entry} entry
     * @param {any} driven
     * @param {Entry} control
     */
    function drive(entry, driven, control) {
        var layer = entry.layer;
        var height = reading(control, "Height", "h");
        if (driven.has_look) {
            var gone = driven.gone_px > 0 ? " * Math.max(0, 1 - Math.max(0, h) / " + driven.gone_px + ")" : "";
            var opacity = transformOf(layer, "ADBE Opacity");
            if (entry.memory.x !== undefined || !opacity.expression) {
                opacity.expression = reading(control, "Opacity", "c") + (gone === "" ? "" : height) + "value * (c / 100)" + gone;
            } else {
                tellLeft(nameOfEntry(entry), "x");
            }
            express(layer, TINT, "ADBE Tint-0001", reading(control, "Color", "c") + "c");
            express(layer, TINT, "ADBE Tint-0002", reading(control, "Color", "c") + "c");
            express(layer, TINT, "ADBE Tint-0003", reading(control, "Color Amount", "c") + "c");
            express(layer, BLUR, "ADBE Gaussian Blur 2-0001", reading(control, "Softness", "c") + "Math.max(0, c)");
        }
        var effect = driven.rising ? ourEffect(layer, MOVE) : null;
        if (effect === null || ourEffect(layer, RAISED) === null) {
            return;
        }
        animatePair(propertyOf(effect, "ADBE Geometry2-0001"), driven.rising.contact, layer.startTime);
        animatePair(propertyOf(effect, "ADBE Geometry2-0002"), driven.rising.contact, layer.startTime);
        animatePair(propertyOf(ourEffect(layer, RAISED), "ADBE Point Control-0001"), driven.rising.raised, layer.startTime);
        express(layer, MOVE, "ADBE Geometry2-0002", height + "var to = effect(" + quoted(RAISED) + ")(1).value;\n"
            + "var part = h / " + driven.rising.step_px + ";\n[value[0] + (to[0] - value[0]) * part, value[1] + (to[1] - value[1]) * part]");
        express(layer, MOVE, "ADBE Geometry2-0003", height + "value * Math.max(0.05, 1 - " + driven.rising.shrink + " * Math.min(h / " + driven.rising.tall_px + ", 1))");
    }

    function express(layer, name, part, text) {
        var effect = ourEffect(layer, name);
        if (effect !== null) {
            propertyOf(effect, part).expression = text;
        }
    }

    var DRIVEN = [
        [TINT, "ADBE Tint-0001"],
        [TINT, "ADBE Tint-0002"],
        [TINT, "ADBE Tint-0003"],
        [BLUR, "ADBE Gaussian Blur 2-0001"],
        [MOVE, "ADBE Geometry2-0002"],
        [MOVE, "ADBE Geometry2-0003"]
    ];

    function release(layer) {
        transformOf(layer, "ADBE Opacity").expression = "";
        for (var i = 0; i < DRIVEN.length; i++) {
            express(layer, DRIVEN[i][0], DRIVEN[i][1], "");
        }
    }

    /* What is driven, and by which words; numbers in them that came from Kagezou too. */
    STATES.x = function (layer) {
        var parts = [transformOf(layer, "ADBE Opacity").expression];
        for (var i = 0; i < DRIVEN.length; i++) {
            var effect = ourEffect(layer, DRIVEN[i][0]);
            parts.push(effect === null ? "none" : propertyOf(effect, DRIVEN[i][1]).expression);
        }
        var moved = ourEffect(layer, MOVE);
        for (i = 0; i < 2 && moved !== null; i++) {
            parts.push(stateOfPart(propertyOf(moved, "ADBE Geometry2-0001"), layer.startTime, i, 0));
            parts.push(stateOfPart(propertyOf(moved, "ADBE Geometry2-0002"), layer.startTime, i, 0));
        }
        return checksum(parts.join("\n"));
    };
