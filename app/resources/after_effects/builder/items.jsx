    /* Items of the project by their tags. There are several of one tag where one was copied or a project was brought in. */
    var FOLDERS = ["Footage", "Background", "Characters", "Shadows", "Set", "Mattes", "Guides"];
    var known = {};
    var comps = [];

    function indexItems() {
        known = {};
        comps = [];
        for (var i = 1; i <= app.project.numItems; i++) {
            var item = app.project.item(i);
            if (item instanceof CompItem) {
                comps.push(item);
            }
            var read = item.comment.indexOf("kagezou:") < 0 ? null : readComment(item.comment);
            if (read !== null) {
                noteItem(item, read.tag);
            }
        }
    }

    /**
     * @param {_ItemClasses} item
     * @param {string} tag
     */
    function noteItem(item, tag) {
        known["$" + tag] = itemsOf(tag).concat([item]);
    }

    function itemsOf(tag) {
        return known["$" + tag] || [];
    }

    function keepItem(item, tag) {
        remember(item, tag, {});
        noteItem(item, tag);
    }

    function folderOf(name, parent) {
        var tag = name === null ? "root" : "folder:" + name;
        if (itemsOf(tag).length === 0) {
            var folder = app.project.items.addFolder(name === null ? title : name);
            keepItem(folder, tag);
            folder.parentFolder = parent;
        }
        return /** @type {FolderItem} */ (itemsOf(tag)[0]);
    }

    /* Nulls and solids lie with what they belong to, not in the folder that After Effects makes for them. */
    /**
     * @param {AVLayer} layer
     * @param {string} name
     * @param {FolderItem} folder
     */
    function moveSource(layer, name, folder) {
        var solids = layer.source.parentFolder;
        layer.source.name = name;
        layer.source.parentFolder = folder;
        if (solids.numItems === 0 && solids.comment === "" && solids.id !== app.project.rootFolder.id) {
            solids.remove();
        }
    }

    /* A lock is against a slip of the hand, so it is no reason to leave a layer alone. */
    function unlocked(layer, work) {
        var isLocked = layer.locked;
        layer.locked = false;
        work();
        if (isLocked) {
            layer.locked = true;
        }
    }

    function hasId(items, item) {
        for (var i = 0; i < items.length; i++) {
            if (items[i].id === item.id) {
                return true;
            }
        }
        return false;
    }

    /* Whether a layer shows one of some items, at any depth of compositions. */
    /**
     * @param {AVLayer} layer
     * @param {AVItem[]} items
     */
    function shows(layer, items) {
        var source = layer.source;
        return Boolean(source) && (hasId(items, source) || (source instanceof CompItem && holds(source, items)));
    }

    /**
     * @param {CompItem} comp
     * @param {AVItem[]} items
     */
    function holds(comp, items) {
        for (var i = 1; i <= comp.numLayers; i++) {
            if (shows(/** @type {AVLayer} */ (comp.layer(i)), items)) {
                return true;
            }
        }
        return false;
    }

    function itemsOfFootage(tag) {
        return itemsOf(coded(tag));
    }

    /**
     * Null where there is none.
     * @param {any} group
     * @param {string} name
     * @returns {Property}
     */
    function propertyOf(group, name) {
        return group.property(name);
    }

    /**
     * @param {AVLayer} layer
     * @param {string} name
     * @returns {Property<any>}
     */
    function transformOf(layer, name) {
        return propertyOf(layer.property("ADBE Transform Group"), name);
    }

    /**
     * @param {AVLayer} layer
     * @returns {PropertyGroup}
     */
    function effectsOf(layer) {
        return /** @type {PropertyGroup} */ (layer.property("ADBE Effect Parade"));
    }
