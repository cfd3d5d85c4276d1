"""The light and the ground of one project for many others: python same_light.py MASTER.kage OTHER.kage ..."""

import sys

import kagezou

master = kagezou.open(sys.argv[1])
failed = 0
for path in sys.argv[2:]:
    try:
        before = kagezou.open(path)
        # Nobody else changes it meanwhile, and what others have changed before is kept.
        after = kagezou.edit(path, lambda cut: cut.with_parts_of(master, "light", "ground"))
    except kagezou.Problem as problem:
        failed = problem.code
        sys.stderr.write(f"{problem}\n")
        continue
    sys.stdout.write(f"{path}: {'as it was' if after == before else 'lit anew'}\n")
    sys.stderr.writelines(f"{path}: {note}\n" for note in after.notes)
sys.exit(failed)
