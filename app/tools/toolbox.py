"""All tools by their names."""

from app.tools.draw import DrawTool
from app.tools.figure import EllipseTool, RectangleTool, RegularPolygonTool, StarTool
from app.tools.freehand import FreehandTool
from app.tools.mark import MarkTool
from app.tools.picture import PictureTool
from app.tools.place import PlaceTool
from app.tools.select import SelectTool
from app.tools.text import TextTool
from app.tools.tool import Tool

TOOLS: dict[str, type[Tool]] = {
    tool.name: tool
    for tool in (
        SelectTool,
        DrawTool,
        FreehandTool,
        RectangleTool,
        EllipseTool,
        RegularPolygonTool,
        StarTool,
        TextTool,
        PictureTool,
        PlaceTool,
        MarkTool,
    )
}
