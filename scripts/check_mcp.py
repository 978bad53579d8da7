"""Lists the tools, solves examples and fetches a link, with the official Python SDK of the Model Context Protocol.

Usage: PLATEAU_URL=http://… check_mcp.py PROGRAM. The client speaks with `PROGRAM mcp` on standard input and output, and
with the server at PLATEAU_URL, which must have the setting http.mcp. It does so by the newest version of the protocol and
by the older one that begins with a handshake. The SDK checks each result against the tool's output schema. The schemas that
`describe` returns are checked with the package jsonschema, which comes with the SDK.
"""

import asyncio
import base64
import json
import os
import struct
import sys
import tempfile
import urllib.request
from pathlib import Path

from jsonschema import Draft202012Validator as Validator
from mcp import Client, StdioServerParameters

KINDS = ["ruled_surface", "minimal_surface", "uniform_mesh", "tensile_structure", "cable_net"]
EXAMPLE = Path(__file__).parent.parent / "api" / "examples" / "helicoid.json"


def validator(schema: dict) -> Validator:
    """A validator of a schema, which has to be valid itself. A reference out of the schema fails as soon as it is followed."""
    Validator.check_schema(schema)
    return Validator(schema)


async def check_schemas(client: Client) -> None:
    """Every kind's example and its statistics satisfy the schemas that `describe` returns, and an empty request does not."""
    tools = {tool.name: tool for tool in (await client.list_tools()).tools}
    for tool in tools.values():
        validator(tool.input_schema), validator(tool.output_schema)
    for kind in KINDS:
        described = (await client.call_tool("describe", {"kind": kind})).structured_content
        request, schema = described["example"]["request"], validator(described["request_schema"])
        schema.validate(request)
        assert not schema.is_valid({"kind": kind}), kind
        solved = (await client.call_tool("solve", {"request": request})).structured_content
        validator(described["statistics_schema"]).validate(solved["statistics"])
        validator(tools["solve"].output_schema).validate(solved)


async def check(server: StdioServerParameters | str, mode: str) -> None:
    async with Client(server, mode=mode) as client:
        listed = await client.list_tools()
        names = [tool.name for tool in listed.tools]
        assert names == ["describe", "solve", "start", "get", "link"], names
        assert all(tool.output_schema and tool.description for tool in listed.tools)

        described = await client.call_tool("describe", {"kind": "minimal_surface"})
        assert "boundaries" in described.structured_content["request_schema"]["required"]

        request = json.loads(EXAMPLE.read_text())
        solved = await client.call_tool("solve", {"request": request})
        job = solved.structured_content
        assert not solved.is_error and job["status"] == "succeeded" and job["warnings"] == [], job
        assert job["statistics"]["converged"] and job["statistics"]["triangles"] > 2000, job["statistics"]
        picture = next(part for part in solved.content if part.type == "image")
        data = base64.b64decode(picture.data)
        assert data.startswith(b"\x89PNG") and struct.unpack(">II", data[16:24]) == (480, 360)

        linked = await client.call_tool("link", {"id": job["id"], "format": "glb"})
        with urllib.request.urlopen(linked.structured_content["url"]) as answer:
            assert answer.read(4) == b"glTF"

        # Any failure of a tool is a result that a model can read.
        request["boundaries"][0][5][1] = "x"
        refused = await client.call_tool("solve", {"request": request})
        assert refused.is_error and "/request/boundaries/0/5/1" in refused.content[0].text, refused
        print(f"{'HTTP' if isinstance(server, str) else 'stdio'}, {mode}: {client.session.protocol_version}: {job['id']}, "
              f"picture of {len(data)} bytes, {linked.structured_content['url']}")


async def main() -> None:
    with tempfile.TemporaryDirectory() as data:
        stdio = StdioServerParameters(command=sys.argv[1], args=["mcp", "--data", data])
        for server in [stdio, os.environ["PLATEAU_URL"] + "/mcp"]:
            for mode in ["auto", "legacy"]:
                await check(server, mode)
        async with Client(os.environ["PLATEAU_URL"] + "/mcp") as client:
            await check_schemas(client)


asyncio.run(main())
