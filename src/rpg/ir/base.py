"""The base of every frozen record in the IR, and the types that its fields share."""

from __future__ import annotations

from typing import Annotated, Any

from pydantic import BaseModel, BeforeValidator, ConfigDict, PlainSerializer, WithJsonSchema


class Record(BaseModel):
    """Plain frozen data: unknown keys are an error, so that a typo in a hand-written file is found."""

    model_config = ConfigDict(frozen=True, extra="forbid", allow_inf_nan=False)

    def __eq__(self, other: object) -> bool:
        # as of any model, without a look at what no record has: private and further attributes, type parameters
        if self is other:
            return True
        return self.__dict__ == other.__dict__ if type(self) is type(other) else NotImplemented


def _as_tuple(value: Any) -> Any:
    return (value,) if isinstance(value, str) else value


def _as_scalar(value: tuple[str, ...]) -> Any:
    return value[0] if len(value) == 1 else list(value)


Names = Annotated[
    tuple[str, ...],
    BeforeValidator(_as_tuple),
    PlainSerializer(_as_scalar, return_type=Any),
    WithJsonSchema({"anyOf": [{"type": "string"}, {"type": "array", "items": {"type": "string"}}]}),
]
"""One or more names of objects; a single name may be written without a list."""
