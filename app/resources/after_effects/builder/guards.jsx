    /* Settings of the project by which shadows would look other than in Kagezou. */
    function checkProject() {
        var space = String(app.project.workingSpace || "");
        var isManaged = space !== "" && space !== "None";
        if (app.project.linearBlending || (isManaged && app.project.linearizeWorkingSpace)) {
            tellNote(WORDS.linear);
        }
        if (isManaged && space.indexOf("sRGB") < 0) {
            tellNote(said(WORDS.space, [space]));
        }
        /* Since After Effects 24. */
        var systems = $.global.ColorManagementSystem;
        if (systems && /** @type {any} */ (app.project).colorManagementSystem === systems.OCIO) {
            tellNote(WORDS.managed);
        }
        for (var i = 0; i < HAND_OFF.footage.length; i++) {
            if (/\.exr$/i.test(HAND_OFF.footage[i].path) && !isManaged) {
                tellNote(WORDS.exr);
            }
        }
    }
