"""A cut from a folder of drawings to After Effects: python to_after_effects.py DRAWINGS OUT."""

import sys
from pathlib import Path

import kagezou


def tell(done: int, whole: int) -> None:
    """Say how far it is."""
    sys.stderr.write(f"\r{done} of {whole}")


drawings, out = Path(sys.argv[1]), Path(sys.argv[2])
out.mkdir(parents=True, exist_ok=True)

cut = kagezou.new({drawings.name: drawings}).with_feet().with_style("Natural")
cut = cut.with_values({"canvas.fps": 24, f"layers.{drawings.name}.shadow.opacity": 0.6})
cut = cut.save(out / f"{drawings.name}.kage", force=True)
made = cut.export(kagezou.AfterEffects(out / "to_ae", skip_existing=True), progress=tell)

for note in (*cut.notes, *made.notes):
    sys.stderr.write(f"\n{note}")
sys.stdout.write(f"{made.where}\n")
