"""Lists the tools, solves examples, cancels one and fetches links, with the official SDK of the Model Context Protocol.

Usage: PLATEAU_URL=http://… check_mcp.py PROGRAM. The client speaks with `PROGRAM mcp` on standard input and output, and
with the server at PLATEAU_URL, which must have the setting http.mcp. It does so by the newest version of the protocol and
by the older one that begins with a handshake. The SDK checks each result against the tool's output schema.
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

from mcp import Client, StdioServerParameters

EXAMPLES = Path(__file__).parent.parent / "api" / "examples"


async def check(server: StdioServerParameters | str, mode: str) -> None:
    async with Client(server, mode=mode) as client:
        listed = await client.list_tools()
        names = [tool.name for tool in listed.tools]
        assert names == ["describe", "solve", "start", "get", "cancel", "link"], names
        assert all(tool.output_schema and tool.description for tool in listed.tools)

        described = await client.call_tool("describe", {"kind": "minimal_surface"})
        assert described.structured_content["members"]["boundaries"].startswith("Required. ")
        described = await client.call_tool("describe", {"kind": "minimal_surface", "whole": True})
        assert "boundaries" in described.structured_content["request_schema"]["required"]

        request = json.loads((EXAMPLES / "helicoid.json").read_text())
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

        proven = {**request, "certify": {"seconds": 0.1}}
        strip = json.loads((EXAMPLES / "two-rails.json").read_text())
        for asked, link, begins in [
            (proven, {"file": "certificate"}, b"{"),
            (strip, {"file": "pattern", "format": "dxf", "query": "profile=cut"}, b"PK"),
            (strip, {"file": "schedule", "query": "part=bends"}, b"piece,"),
        ]:
            made = await client.call_tool("solve", {"request": asked})
            linked_file = await client.call_tool("link", {"id": made.structured_content["id"], **link})
            assert not linked_file.is_error, linked_file
            with urllib.request.urlopen(linked_file.structured_content["url"]) as answer:
                assert answer.read().startswith(begins), link

        # A job that has ended already stays as it is.
        started = await client.call_tool("start", {"request": {**request, "cache": "bypass"}})
        cancelled = await client.call_tool("cancel", {"id": started.structured_content["id"]})
        assert cancelled.structured_content["id"] == started.structured_content["id"], cancelled
        assert cancelled.structured_content["status"] in ("cancelled", "succeeded"), cancelled

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


asyncio.run(main())
