"""One picture into all its files: encoded once, each file put in place as a whole."""

from kagezou.export.ledger import content_hash
from kagezou.export.pictures import Picture
from kagezou.export.planning import FrameJob
from kagezou.io.files.atomic import let_go_of_link, write_bytes


def write_all(job: FrameJob, picture: Picture) -> str:
    """Write a picture into every file of its job, in the format of their suffix; return the hash of its bytes.

    Raises
    ------
    DiskFullProblem, OutputProblem
        A file cannot be written; what was there is still there.
    """
    first, *others = (target.path for target in job.targets)
    for path in (first, *others):
        let_go_of_link(path)
    data = picture.write(first)
    for path in others:
        write_bytes(path, data)
    return content_hash(data)
