    /* What the script remembers lies in comments, which go with layers and items wherever they are renamed, moved,
       precomposed, copied or undone: kagezou:PROJECT:TAG #NAME=STATE,... with the user's own words before and after it. */
    var identity = "";
    var title = "";

    /* A tag is one word, whatever the ids in it are. */
    function coded(tag) {
        return tag.replace(/[\s%#]/g, function (sign) {
            return "%" + sign.charCodeAt(0).toString(16);
        });
    }

    function headOf() {
        return "kagezou:" + identity + ":";
    }

    /* Null for what is not ours; an older version's states are not understood, so what it made counts as it is. */
    function readComment(comment) {
        var start = comment.indexOf(headOf());
        var found = start < 0 ? null : /^([^\s#]+)(?: #(\S*))?([\s\S]*)$/.exec(comment.substring(start + headOf().length));
        if (found === null) {
            return null;
        }
        return { before: comment.substring(0, start), tag: found[1], memory: memoryOf(found[2] || ""), after: found[3] };
    }

    function memoryOf(text) {
        var memory = {};
        var parts = text.split(",");
        for (var i = 0; i < parts.length; i++) {
            var at = parts[i].indexOf("=");
            if (at > 0) {
                memory[parts[i].substring(0, at)] = parts[i].substring(at + 1);
            }
        }
        return memory;
    }

    function remember(thing, tag, memory) {
        var known = readComment(thing.comment);
        var parts = [];
        for (var name in memory) {
            if (memory.hasOwnProperty(name) && memory[name] !== "") {
                parts.push(name + "=" + memory[name]);
            }
        }
        var ours = headOf() + tag + (parts.length > 0 ? " #" + parts.join(",") : "");
        var comment = known === null ? ours + (thing.comment === "" ? "" : " " + thing.comment) : known.before + ours + known.after;
        if (comment !== thing.comment) {
            thing.comment = comment;
        }
    }

    function checksum(text) {
        return numberOfText(text).toString(36);
    }

    function numberOfText(text) {
        var sum = 7;
        for (var i = 0; i < text.length; i++) {
            sum = (sum * 31 + text.charCodeAt(i)) % 4294967296;
        }
        return sum;
    }

    /* Everything that was ever made, four signs each, in the comments of our folders: what of it is found nowhere was
       deleted. A comment holds 15999 bytes. */
    var SIGNS = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_";
    var MOST_MADE = 3600;
    var made = {};
    var madeList = [];
    var hasLedger = false;

    function signsOf(tag) {
        var number = numberOfText(tag);
        var signs = "";
        for (var i = 0; i < 4; i++) {
            signs += SIGNS.charAt(number % 64);
            number = Math.floor(number / 64);
        }
        return signs;
    }

    function readLedger() {
        var keepers = ledgerFolders().concat(itemsOf("comp:main"));
        for (var i = 0; i < keepers.length; i++) {
            var text = readComment(keepers[i].comment).memory.t || "";
            hasLedger = hasLedger || text !== "";
            for (var j = 0; j + 4 <= text.length; j += 4) {
                noteSigns(text.substring(j, j + 4));
            }
        }
    }

    function noteSigns(signs) {
        if (!made["$" + signs]) {
            made["$" + signs] = true;
            madeList.push(signs);
        }
    }

    function noteMade(tag) {
        noteSigns(signsOf(tag));
    }

    /* Every folder named by its tag, the root first. */
    function ledgerFolders() {
        var folders = itemsOf("root");
        for (var i = 0; i < FOLDERS.length; i++) {
            folders = folders.concat(itemsOf("folder:" + FOLDERS[i]));
        }
        return folders;
    }

    function writeLedger() {
        var folders = ledgerFolders();
        for (var i = 0; i < folders.length; i++) {
            var tag = readComment(folders[i].comment).tag;
            remember(folders[i], tag, { t: madeList.slice(i * MOST_MADE, (i + 1) * MOST_MADE).join("") });
        }
        /* Folders may be thrown away. */
        var mains = itemsOf("comp:main");
        for (i = 0; i < mains.length; i++) {
            var read = readComment(mains[i].comment);
            read.memory.t = madeList.slice(0, MOST_MADE / 2).join("");
            remember(mains[i], read.tag, read.memory);
        }
    }
