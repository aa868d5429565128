"""The JSON Schema of robot files, for editors.

`python -m dhgen.robot.editor_schema FILE` writes it.
"""

from __future__ import annotations

import json
import sys
from pathlib import Path
from typing import TYPE_CHECKING

from pydantic.json_schema import GenerateJsonSchema, JsonSchemaValue

from dhgen.robot.schema import RobotFile

if TYPE_CHECKING:
    from pydantic_core.core_schema import WithDefaultSchema


class _EditorSchema(GenerateJsonSchema):
    """Without titles, which only repeat the keys, and defaults, which only say "left out"."""

    def field_title_should_be_set(self, schema: object) -> bool:  # noqa: ARG002
        return False

    def default_schema(self, schema: WithDefaultSchema) -> JsonSchemaValue:
        described = super().default_schema(schema)
        if not isinstance(described.get("default"), str):
            described.pop("default", None)
        return described


def schema_text() -> str:
    """The JSON Schema of robot files, as it is committed for editors."""
    schema = RobotFile.model_json_schema(schema_generator=_EditorSchema)
    schema["$schema"] = _EditorSchema.schema_dialect
    schema["oneOf"] = [{"required": ["joints"]}, {"required": ["axes"]}]
    return json.dumps(schema, indent=2, sort_keys=True) + "\n"


def main(arguments: list[str]) -> None:
    """Write the schema to the given file, robots/robot.schema.json without one."""
    target = Path(arguments[0] if arguments else "robots/robot.schema.json")
    target.write_text(schema_text(), encoding="utf-8")


if __name__ == "__main__":
    main(sys.argv[1:])
