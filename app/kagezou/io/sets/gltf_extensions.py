"""Extensions of glTF: those that are done, those that do not matter for a shape, and all others, which are told."""

from importlib.util import find_spec
from typing import Final

from kagezou.errors import InputProblem
from kagezou.extras import DRACO as DRACO_PART
from kagezou.io.files.faults import input_problem
from kagezou.io.sets.gltf import Gltf
from kagezou.io.sets.triangles import listed
from kagezou.message import Message

DRACO: Final = "KHR_draco_mesh_compression"
_DONE: Final = ("KHR_mesh_quantization", "EXT_mesh_gpu_instancing", "KHR_node_visibility", DRACO)
_NO_MATTER: Final = (
    "ADOBE_materials_",
    "AGI_stk_metadata",
    "CESIUM_primitive_outline",
    "EXT_feature_metadata",
    "EXT_instance_features",
    "EXT_lights_",
    "EXT_mesh_features",
    "EXT_mesh_manifold",
    "EXT_structural_metadata",
    "EXT_texture_",
    "FB_ngon_encoding",
    "KHR_animation_pointer",
    "KHR_audio",
    "KHR_interactivity",
    "KHR_lights_",
    "KHR_materials_",
    "KHR_node_hoverability",
    "KHR_node_selectability",
    "KHR_physics_",
    "KHR_techniques_webgl",
    "KHR_texture_",
    "KHR_xmp",
    "MSFT_audio",
    "MSFT_lod",
    "MSFT_packing_",
    "MSFT_texture_",
    "OMI_",
    "VRM",
)
"""How the names of extensions begin that say nothing of a shape: colours, lights, sounds, what one may know of it."""

DRACO_MISSING: Final = Message(
    "it is compressed with Draco, which needs the package DracoPy: {how}", how=DRACO_PART.how
)


def can_read_draco() -> bool:
    """Whether the optional package for Draco is installed."""
    return find_spec(DRACO_PART.module) is not None


def refused(file: Gltf) -> InputProblem | None:
    """Return the problem of a file that requires what is not done, None for any other."""
    required = _names(file, "extensionsRequired")
    if DRACO in required and not can_read_draco():
        return input_problem(file.path, DRACO_MISSING)
    packed = [name for name in required if name.endswith("_meshopt_compression")]
    if packed:
        return input_problem(
            file.path, Message("it is compressed ({name}): please export it without compression", name=packed[0])
        )
    missing = [name for name in required if not _is_done(name)]
    if missing:
        return input_problem(
            file.path, Message("it requires the extensions {names}, which are not read", names=listed(missing))
        )
    return None


def extension_notes(file: Gltf) -> tuple[Message, ...]:
    """Return which extensions it uses that may matter and are not done."""
    missing = [name for name in _names(file, "extensionsUsed") if not _is_done(name)]
    return (Message("the extensions {names} are not used", names=listed(missing)),) if missing else ()


def _is_done(name: str) -> bool:
    return name in _DONE or name.startswith(_NO_MATTER)


def _names(file: Gltf, which: str) -> list[str]:
    found = file.tree.get(which) or []
    if not isinstance(found, list):
        raise TypeError(found)
    return [str(name) for name in found]
