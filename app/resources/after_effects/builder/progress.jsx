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
