"""Where a figure stands: feet in the outlines of drawings, and what they do over time.

`outline` keeps of a drawing what is needed, `finding.found_feet` finds the feet of all drawings of a layer, and
`stances.stances` says of what frames show (`seen`) which foot carries, where the ground is and how high the figure is.

It may use numpy and the geometry below it; everything is a frozen value or a pure function.
It must never know a document, a file or a window: outlines and numbers come in, feet and ground rows go out.
"""
