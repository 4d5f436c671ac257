"""The 162 normals of Quake II: the corners of a sphere of triangles. A vertex of an MD2 file names one by its
number.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from statwalk.maths.arrays import Floats

_SIZES = (
    0,
    0.147621,
    0.16246,
    0.238856,
    0.262866,
    0.295242,
    0.309017,
    0.425325,
    0.442863,
    0.5,
    0.525731,
    0.587785,
    0.681718,
    0.688191,
    0.716567,
    0.809017,
    0.850651,
    0.864188,
    0.951056,
    0.955423,
    1,
)
"""what a coordinate may be: a, b, c …; a capital is negative"""
_NORMALS = """
Kaq Idr Fat Gjp Ces aau aqk Bom bom akq gjp kaq fat idr ces Mbo Pgj Lhn Qka Rid Omb Nlh Jpg Dri Hnl
OmB JpG Kqa aqK DrI atF EsC aua atf Esc dri esc jpg drI esC jpG qka omb omB kqa hnl rid nlh pgj mbo
lhn tfa uaa sce qKa tFa rId sCe pGj mBo qak riD pgJ scE kaQ mbO mBO qaK pGJ rID sCE boM gjP hnL idR
lhN nlH BoM GjP akQ KaQ IdR FaT CeS aaU faT ceS IDR GJP CES aQK BOM bOM aKQ gJP iDR cES dRI jPG hNL
oMB nLH lHN aTF aUa eSC aQk aTf dRi eSc jPg oMb kQa DRI JPG ESC QKa OMB OMb KQa JPg DRi ESc RId PGj
NLh MBo IDr LHn GJp BOm HNl CEs iDr cEs gJp bOm aKq hNl lHn nLh Tfa Sce Uaa Qak TFa SCe RiD ScE PgJ
RID SCE PGJ MbO MBO QaK NlH LhN HnL HNL LHN NLH
"""
MOST_AT_ONCE = 1 << 14


def _read() -> NDArray[np.float32]:
    """Returns the normals (162, 3) along the axes of the file."""
    letters = [[ord(letter) for letter in word] for word in _NORMALS.split()]
    codes = np.array(letters)
    is_negative = codes < ord("a")
    sizes = np.array(_SIZES)[codes - np.where(is_negative, ord("A"), ord("a"))]
    vectors = np.where(is_negative, -sizes, sizes)
    lengths = np.sqrt((vectors * vectors).sum(-1, keepdims=True))
    return np.asarray(vectors / lengths, np.float32)


NORMALS = _read()


def nearest_normals(vectors: Floats) -> NDArray[np.uint8]:
    """Returns the numbers (…) of the normals that are nearest to unit vectors (…, 3)."""
    flat = vectors.reshape(-1, 3)
    numbers = np.empty(len(flat), np.uint8)
    for first in range(0, len(flat), MOST_AT_ONCE):
        rows = slice(first, first + MOST_AT_ONCE)
        numbers[rows] = (flat[rows] @ NORMALS.T).argmax(-1)
    return numbers.reshape(vectors.shape[:-1])
