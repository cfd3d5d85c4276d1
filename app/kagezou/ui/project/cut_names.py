"""What files that are made of a cut are called at first."""

from kagezou.document.model import Document
from kagezou.export.names import safe_names


def output_name(document: Document, project_name: str) -> str:
    """Return what the slate says, as every file system takes it; the project's name where it says nothing."""
    label = document.slate.label
    return safe_names([label])[label] if label else project_name
