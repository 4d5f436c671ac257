from typing import Annotated, Literal

import pytest
from pydantic import BaseModel, Field
from statwalk.web.field_members import members_at


class Leaf(BaseModel):
    leaf: str = ""
    kind: Literal["leaf"] = "leaf"
    colour: str = ""


class Branch(BaseModel):
    kind: Literal["branch"] = "branch"
    parts: "list[Annotated[Branch | Leaf, Field(discriminator='kind')]]" = []
    by_name: dict[str, Leaf] = {}
    wide: float | None = Field(None, alias="width")


@pytest.mark.parametrize(
    ("place", "members"),
    [
        ((), ["kind", "parts", "by_name", "width"]),
        (("parts", 3, "leaf"), ["leaf", "kind", "colour"]),
        (("parts", 0, "branch", "parts", 1, "leaf"), ["leaf", "kind", "colour"]),
        (("by_name", "any"), ["leaf", "kind", "colour"]),
        (("width",), []),
        (("nothing", 1), []),
    ],
)
def test_the_members_at_a_place(place: tuple[str | int, ...], members: list[str]) -> None:
    assert members_at(Branch, place) == members


def test_what_is_no_model_has_no_members() -> None:
    assert members_at(None, ("speed",)) == members_at(dict, ("a",)) == []
