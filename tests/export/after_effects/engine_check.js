/* What After Effects' engine reads otherwise than the standard has it: node engine_check.js ACORN SCRIPT prints a line each.
   Conditions in a row are taken from the left, && and || are as strong as each other, and reserved words are no names. */
"use strict";
const fs = require("fs");
const [, , acornPath, scriptPath] = process.argv;
const acorn = require(acornPath);
const RESERVED = "abstract boolean break byte case catch char class const continue debugger default delete do double else enum export extends false final finally float for function goto if implements import in instanceof int interface long native new null package private protected public return short static super switch synchronized this throw throws transient true try typeof var void volatile while with".split(" ");

function complain(node, words) {
    console.log(`${node.loc.start.line}: ${words}`);
}

function look(node) {
    if (node.type === "ConditionalExpression") {
        for (const part of [node.test, node.consequent, node.alternate]) if (part.type === "ConditionalExpression") complain(part, "a condition in a condition wants parentheses");
    }
    if (node.type === "LogicalExpression") {
        for (const part of [node.left, node.right]) if (part.type === "LogicalExpression" && part.operator !== node.operator) complain(part, "&& beside || wants parentheses");
    }
    if (node.type === "MemberExpression" && !node.computed && RESERVED.includes(node.property.name)) complain(node, "a reserved word as a name");
    if (node.type === "Property" && node.key.type === "Identifier" && RESERVED.includes(node.key.name)) complain(node, "a reserved word as a name");
    for (const value of Object.values(node)) for (const child of [].concat(value)) if (child && typeof child.type === "string") look(child);
}

look(acorn.parse(fs.readFileSync(scriptPath, "utf8"), { ecmaVersion: 3, preserveParens: true, locations: true }));
