"""All tools by their names, with nothing begun."""

from app.tools.draw import DrawTool
from app.tools.figure import FIGURES, FigureTool
from app.tools.freehand import FreehandTool
from app.tools.mark import MarkTool
from app.tools.picture import PictureTool
from app.tools.place import PlaceTool
from app.tools.select import SelectTool
from app.tools.text import TextTool
from app.tools.tool import Tool

TOOLS: dict[str, Tool] = {
    tool.name: tool
    for tool in (
        SelectTool(),
        DrawTool(),
        FreehandTool(),
        *(FigureTool(figure) for figure in FIGURES),
        TextTool(),
        PictureTool(),
        PlaceTool(),
        MarkTool(),
    )
}
