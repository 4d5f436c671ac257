"""The mutators of all formats: each seed is a valid file with one to four changes made by chance.

Each file ends in a Character that moves and has finite numbers only, or in an error of statwalk's that names
a place, within 5 s; no other exception. `python benchmarks/reliability.py files` reads many.
"""

from torture.capture_files import BVH, TRC
from torture.chunk_files import CHUNK
from torture.detail_files import CHUNK_DETAIL, GLTF_DETAIL
from torture.faq_files import FAQ_CHARACTER, FAQ_CONSTRAINTS, FAQ_KEYS, FAQ_SKELETON, FAQ_SKIN
from torture.gltf_files import GLTF_MODEL
from torture.machine_files import LAYERS, MACHINE
from torture.md2_files import MD2
from torture.x_files import X

MUTATORS = {
    "gltf": GLTF_MODEL,
    "gltf-detail": GLTF_DETAIL,
    "chunk": CHUNK,
    "chunk-detail": CHUNK_DETAIL,
    "x": X,
    "md2": MD2,
    "bvh": BVH,
    "trc": TRC,
    "faq-skeleton": FAQ_SKELETON,
    "faq-keys": FAQ_KEYS,
    "faq-skin": FAQ_SKIN,
    "faq-constraints": FAQ_CONSTRAINTS,
    "faq-character": FAQ_CHARACTER,
    "machine": MACHINE,
    "machine-layers": LAYERS,
}
