    /* What is said, in the language of After Effects. */
    var ja = String(app.isoLanguage).indexOf("ja") === 0;
    var WORDS = {
        undo: ja ? "Kagezou \u306e\u5f71\u3092\u8aad\u307f\u8fbc\u307f" : "Import Kagezou shadows",
        missing: ja ? "\u30d5\u30a1\u30a4\u30eb\u304c\u898b\u3064\u304b\u308a\u307e\u305b\u3093: " : "This file is missing: ",
        refused: ja ? "After Effects \u3067\u8aad\u307f\u8fbc\u3081\u307e\u305b\u3093: " : "After Effects cannot import this file: ",
        save: ja ? "\u30b9\u30af\u30ea\u30d7\u30c8\u3092\u4fdd\u5b58\u3057\u3066\u304b\u3089\u5b9f\u884c\u3057\u3066\u304f\u3060\u3055\u3044\u3002" : "Run this script from its file, not as pasted text.",
        failed: ja ? "Kagezou: \u8aad\u307f\u8fbc\u307f\u306b\u5931\u6557\u3057\u307e\u3057\u305f\u3002\n" : "Kagezou: the import failed.\n",
        other: ja ? "\u540c\u3058\u540d\u524d\u306e Kagezou \u306e\u5f71\u304c\u3001\u5225\u306e\u30d5\u30a9\u30eb\u30c0\u30fc\u304b\u3089\u3059\u3067\u306b\u8aad\u307f\u8fbc\u307e\u308c\u3066\u3044\u307e\u3059:\n" : "Kagezou shadows of the same name are already in this project, from another folder:\n",
        replace: ja ? "\n\n\u3053\u306e\u30d5\u30a9\u30eb\u30c0\u30fc\u306e\u5185\u5bb9\u3067\u7f6e\u304d\u63db\u3048\u307e\u3059\u304b\uff1f\u300c\u3044\u3044\u3048\u300d\u3067\u306f\u5225\u306e\u30ab\u30c3\u30c8\u3068\u3057\u3066\u4e26\u3079\u3066\u8aad\u307f\u8fbc\u307f\u307e\u3059\u3002" : "\n\nReplace them with those of this folder? With No they are imported beside them, as another cut.",
        settings: ja ? "\u6b21\u306e\u30b3\u30f3\u30dd\u30b8\u30b7\u30e7\u30f3\u8a2d\u5b9a\u306f After Effects \u3067\u5909\u66f4\u3055\u308c\u3001\u305d\u306e\u5f8c Kagezou \u3067\u3082\u5909\u308f\u308a\u307e\u3057\u305f:\n" : "These settings of compositions were changed in After Effects, and later in Kagezou, too:\n",
        take: ja ? "\n\nKagezou \u306e\u8a2d\u5b9a\u306b\u3057\u307e\u3059\u304b\uff1f\u300c\u3044\u3044\u3048\u300d\u3067\u306f\u4eca\u306e\u307e\u307e\u6b8b\u3057\u307e\u3059\u3002" : "\n\nTake those of Kagezou? With No they stay as they are.",
        updated: ja ? "Kagezou: \u300c%1\u300d\u3092\u66f4\u65b0\u3057\u307e\u3057\u305f\u3002" : "Kagezou: %1 was brought up to date.",
        unchanged: ja ? "Kagezou: \u300c%1\u300d\u306b\u5909\u66f4\u306f\u3042\u308a\u307e\u305b\u3093\u3002" : "Kagezou: %1 is up to date already.",
        changed: ja ? "\u5909\u66f4:" : "Changed:",
        added: ja ? "\u8ffd\u52a0:" : "New:",
        left: ja ? "After Effects \u3067\u5909\u66f4\u3055\u308c\u3066\u3044\u308b\u305f\u3081\u3001\u305d\u306e\u307e\u307e\u6b8b\u3057\u307e\u3057\u305f:" : "Changed by you in After Effects, so left as it is:",
        foreign: ja ? "\u5225\u306e\u7d20\u6750\u3092\u8868\u793a\u3057\u3066\u3044\u308b\u305f\u3081\u3001\u305d\u306e\u307e\u307e\u6b8b\u3057\u307e\u3057\u305f:" : "Shows other footage, so left alone:",
        deleted: ja ? "After Effects \u3067\u524a\u9664\u3055\u308c\u305f\u304b\u3001\u30b3\u30e1\u30f3\u30c8\u304c\u6d88\u3055\u308c\u305f\u305f\u3081\u3001\u8ffd\u52a0\u3057\u307e\u305b\u3093\u3067\u3057\u305f\uff08Shift \u30ad\u30fc\u3092\u62bc\u3057\u306a\u304c\u3089\u5b9f\u884c\u3059\u308b\u3068\u623b\u308a\u307e\u3059\uff09:" : "Deleted by you in After Effects, or its comment was, so not added again (hold Shift as the script starts to have it back):",
        gone: ja ? "Kagezou \u306e\u30d7\u30ed\u30b8\u30a7\u30af\u30c8\u306b\u3082\u3046\u306a\u3044\u305f\u3081\u3001\u975e\u8868\u793a\u306b\u3057\u307e\u3057\u305f:" : "No longer in the Kagezou project, so switched off:",
        back: ja ? "Kagezou \u306e\u30d7\u30ed\u30b8\u30a7\u30af\u30c8\u306b\u623b\u3063\u305f\u305f\u3081\u3001\u8868\u793a\u3057\u307e\u3057\u305f:" : "In the Kagezou project again, so switched on:",
        notes: ja ? "\u6ce8\u610f:" : "Note:",
        more: ja ? "... \u4ed6 %1 \u4ef6" : "... and %1 more",
        copies: ja ? "\u30b3\u30f3\u30dd\u30b8\u30b7\u30e7\u30f3\u306e\u8907\u88fd\u3082\u66f4\u65b0\u3057\u307e\u3057\u305f: %1" : "Copies of the composition were brought up to date as well: %1",
        compAnew: ja ? "\u30b3\u30f3\u30dd\u30b8\u30b7\u30e7\u30f3\u300c%1\u300d\u306f\u6b8b\u3063\u3066\u3044\u306a\u304b\u3063\u305f\u305f\u3081\u3001\u4f5c\u308a\u76f4\u3057\u307e\u3057\u305f\u3002" : "Nothing was left of the composition %1, so it was built anew.",
        compGone: ja ? "\u30b3\u30f3\u30dd\u30b8\u30b7\u30e7\u30f3\u300c%1\u300d\u306f\u524a\u9664\u3055\u308c\u305f\u305f\u3081\u3001\u4f5c\u308a\u76f4\u3057\u307e\u305b\u3093\u3067\u3057\u305f\u3002\u4ed6\u306e\u5834\u6240\u306b\u3042\u308b\u30ec\u30a4\u30e4\u30fc\u306f\u66f4\u65b0\u3057\u307e\u3057\u305f\u3002" : "The composition %1 was deleted, so it was not built again; its layers elsewhere were brought up to date.",
        rateDiffers: ja ? "\u300c%1\u300d\u306e\u30d5\u30ec\u30fc\u30e0\u30ec\u30fc\u30c8\u306f %3 \u3067\u306f\u306a\u304f %2 \u306b\u306a\u308a\u307e\u3057\u305f\u3002\u6700\u5f8c\u306e\u30d5\u30ec\u30fc\u30e0\u307e\u3067\u306b\u5f71\u304c\u305a\u308c\u307e\u3059\u3002" : "%1 has %2 frames a second instead of %3; shadows drift away until its last frame.",
        ownLayers: ja ? "\u300c%1\u300d\u306e\u30b5\u30a4\u30ba\u304c\u5909\u308f\u308a\u307e\u3057\u305f\u304c\u3001\u3054\u81ea\u8eab\u3067\u8ffd\u52a0\u3057\u305f\u30ec\u30a4\u30e4\u30fc\u306f\u52d5\u304b\u3057\u3066\u3044\u307e\u305b\u3093\u3002" : "The size of %1 changed, and your own layers in it were not moved.",
        workArea: ja ? "\u300c%1\u300d\u306e\u30ef\u30fc\u30af\u30a8\u30ea\u30a2\u3092\u8a2d\u5b9a\u3067\u304d\u307e\u305b\u3093\u3067\u3057\u305f\u3002" : "The work area of %1 could not be set.",
        linear: ja ? "\u30d7\u30ed\u30b8\u30a7\u30af\u30c8\u8a2d\u5b9a\u3067\u300c1.0 \u306e\u30ac\u30f3\u30de\u3092\u4f7f\u7528\u3057\u3066\u30ab\u30e9\u30fc\u3092\u30d6\u30ec\u30f3\u30c9\u300d\u304c\u30aa\u30f3\u306e\u305f\u3081\u3001\u5f71\u306f Kagezou \u3088\u308a\u8584\u304f\u898b\u3048\u307e\u3059\u3002" : "The project blends colors using 1.0 gamma, so shadows look lighter than in Kagezou (Project Settings > Color).",
        space: ja ? "\u4f5c\u696d\u7528\u30b9\u30da\u30fc\u30b9\u304c %1 \u306e\u305f\u3081\u3001\u8272\u3068\u5f71\u306e\u6fc3\u3055\u304c Kagezou \u3068\u7570\u306a\u308a\u307e\u3059\u3002Kagezou \u3068\u540c\u3058\u306b\u3059\u308b\u306b\u306f\u300c\u306a\u3057\u300d\u307e\u305f\u306f sRGB \u306b\u3057\u3066\u304f\u3060\u3055\u3044\u3002" : "The working space is %1, so colors and shadows differ from Kagezou. With None or sRGB they are the same (Project Settings > Color).",
        managed: ja ? "\u30ab\u30e9\u30fc\u30de\u30cd\u30b8\u30e1\u30f3\u30c8\u304c OCIO \u306e\u305f\u3081\u3001\u8272\u3068\u5f71\u306e\u6fc3\u3055\u304c Kagezou \u3068\u7570\u306a\u308b\u3053\u3068\u304c\u3042\u308a\u307e\u3059\u3002" : "Colors are managed by OCIO, so colors and shadows may differ from Kagezou (Project Settings > Color).",
        exr: ja ? "EXR \u306f\u30ea\u30cb\u30a2\u3067\u3059\u3002\u30d7\u30ed\u30b8\u30a7\u30af\u30c8\u8a2d\u5b9a\u3067\u4f5c\u696d\u7528\u30b9\u30da\u30fc\u30b9\u3092 sRGB\u3001\u8272\u6df1\u5ea6\u3092 32 bit \u306b\u3057\u3066\u304f\u3060\u3055\u3044\u3002" : "EXR is linear light: choose sRGB as the working space and 32 bits per channel (Project Settings > Color).",
        graphics: ja ? "\u30a8\u30c3\u30bb\u30f3\u30b7\u30e3\u30eb\u30b0\u30e9\u30d5\u30a3\u30c3\u30af\u30b9\u306b\u8ffd\u52a0\u3067\u304d\u307e\u305b\u3093\u3067\u3057\u305f: %1" : "The controls could not be added to Essential Graphics: %1",
        controls: {
            "Opacity": ja ? "\u5f71\u306e\u4e0d\u900f\u660e\u5ea6" : "Shadow Opacity",
            "Color": ja ? "\u5f71\u306e\u30ab\u30e9\u30fc" : "Shadow Color",
            "Color Amount": ja ? "\u5f71\u306e\u30ab\u30e9\u30fc\u306e\u9069\u7528\u91cf" : "Shadow Color Amount",
            "Softness": ja ? "\u5f71\u306e\u307c\u304b\u3057" : "Shadow Softness",
            "Height": ja ? "\u5f71\u306e\u9ad8\u3055" : "Shadow Height"
        },
        aspects: {
            o: ja ? "\u4e0d\u900f\u660e\u5ea6" : "opacity",
            p: ja ? "\u30c8\u30e9\u30f3\u30b9\u30d5\u30a9\u30fc\u30e0" : "transform",
            r: ja ? "\u30bf\u30a4\u30e0\u30ea\u30de\u30c3\u30d7" : "time remapping",
            m: ja ? "\u63cf\u753b\u30e2\u30fc\u30c9" : "blending mode",
            c: ja ? "\u30ab\u30e9\u30fc" : "color",
            b: ja ? "\u958b\u59cb\u6642\u9593" : "start time",
            i: ja ? "\u30a4\u30f3\u30dd\u30a4\u30f3\u30c8" : "in point",
            e: ja ? "\u30a2\u30a6\u30c8\u30dd\u30a4\u30f3\u30c8" : "out point",
            l: ja ? "\u30e9\u30d9\u30eb" : "label",
            k: ja ? "\u30b9\u30e9\u30a4\u30c0\u30fc" : "sliders",
            x: ja ? "\u30a8\u30af\u30b9\u30d7\u30ec\u30c3\u30b7\u30e7\u30f3" : "expressions",
            h: ja ? "\u540d\u524d" : "name",
            u: ja ? "\u91cd\u306d\u9806" : "stacking order",
            n: ja ? "\u30de\u30fc\u30ab\u30fc" : "markers",
            S: ja ? "\u30b5\u30a4\u30ba" : "size",
            F: ja ? "\u30d5\u30ec\u30fc\u30e0\u30ec\u30fc\u30c8" : "frame rate",
            D: ja ? "\u30c7\u30e5\u30ec\u30fc\u30b7\u30e7\u30f3" : "duration",
            A: ja ? "\u30ef\u30fc\u30af\u30a8\u30ea\u30a2" : "work area",
            N: ja ? "\u958b\u59cb\u30d5\u30ec\u30fc\u30e0" : "start frame",
            P: ja ? "\u30d4\u30af\u30bb\u30eb\u7e26\u6a2a\u6bd4" : "pixel aspect ratio",
            f: ja ? "\u30d5\u30a1\u30a4\u30eb" : "file",
            q: ja ? "\u30d5\u30c3\u30c6\u30fc\u30b8\u306e\u5909\u63db" : "interpretation"
        }
    };

    /* With %1, %2 ... filled in. */
    function said(words, values) {
        for (var i = 0; i < values.length; i++) {
            words = words.split("%" + (i + 1)).join(String(values[i]));
        }
        return words;
    }
