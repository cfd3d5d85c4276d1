"""A batch as a job of a render farm: a task for each cut, and the report when all of them are over with.

The bundle is one of Open Job Description, as that of frames is. A task whose cut fails does not fail itself, so that
the others and the report are made; the step of the report fails where a cut did.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Final

from kagezou.batch.cut import Cut
from kagezou.errors import UsageProblem
from kagezou.export.farm import (
    ASSETS,
    NOTICE_S,
    PARAMETERS,
    TEMPLATE,
    Json,
    job_name,
    write_job,
)
from kagezou.export.farm_parameters import shown_as
from kagezou.io.files.faults import shown
from kagezou.message import Message

_MOST_TASKS: Final = 1024
"""A list of values of a parameter has no more, by the specification."""

_PLACES: Final = "Places"
_CUTS, _REPORT = "Cuts", "Report"
_REPORT_S: Final = 600
_MEMORY_MIB: Final = 2048
_LEAST_CORES: Final = 2


@dataclass(frozen=True, slots=True)
class BatchJob:
    """What a farm is to make.

    Parameters
    ----------
    cuts
        All cuts, with absolute paths.
    output
        Where each has its folder, absolute.
    template
        The project that is taken from, absolute; None without one.
    words
        What is typed for each cut besides its place and the template.
    report_words
        What is typed for the report.
    program
        How the program is called on the workers.
    cut_minutes
        How long a cut may take.
    """

    cuts: tuple[Cut, ...]
    output: Path
    template: Path | None
    words: tuple[str, ...]
    report_words: tuple[str, ...] = ()
    program: str = "kagezou"
    cut_minutes: int = 120


def write_batch_job(job: BatchJob, folder: Path) -> tuple[Path, ...]:
    """Write a job bundle into a folder, which is made if need be, and return its files.

    Raises
    ------
    UsageProblem
        A name or a path cannot be said in a job, there are too many cuts for one, or it would lie in the output.
    DiskFullProblem, OutputProblem
        A file cannot be written.
    """
    if len(job.cuts) > _MOST_TASKS:
        raise UsageProblem(
            Message("a job has at most {most} cuts, not {cuts}; make several", most=_MOST_TASKS, cuts=len(job.cuts))
        )
    if job.output in folder.parents:
        raise UsageProblem(Message("{path}: a job is not written among the cuts that it makes", path=shown(folder)))
    for text in (*(each.name for each in job.cuts), *(str(each.path) for each in job.cuts), *job.words):
        if "{{" in text:
            raise UsageProblem(Message("{text!r} cannot be named in a job: it has braces", text=text))
    trees = {
        TEMPLATE: batch_template(job),
        PARAMETERS: {"parameterValues": _values(job)},
        ASSETS: {"assetReferences": _assets(job)},
    }
    return write_job(trees, folder, job.output)


def batch_template(job: BatchJob) -> Json:
    """Return the job template; output, template and program stay parameters of the job."""
    return {
        "specificationVersion": "jobtemplate-2023-09",
        "name": job_name(job.output.name),
        "parameterDefinitions": _definitions(job),
        "steps": [_cut_step(job), _report_step(job)],
    }


def _cut_step(job: BatchJob) -> Json:
    place = ["auto", "{{Task.Param.Source}}", "--as={{Task.Param.Name}}", "--output={{Param.OutputDir}}"]
    template = [] if job.template is None else ["--template={{Param.TemplateFile}}"]
    return {
        "name": _CUTS,
        "parameterSpace": {
            "taskParameterDefinitions": [
                {"name": "Name", "type": "STRING", "range": [each.name for each in job.cuts]},
                {"name": "Source", "type": "PATH", "range": [str(each.path) for each in job.cuts]},
            ],
            "combination": "(Name, Source)",
        },
        "hostRequirements": {
            "amounts": [
                {"name": "amount.worker.vcpu", "min": _LEAST_CORES},
                {"name": "amount.worker.memory", "min": _MEMORY_MIB},
            ]
        },
        "script": {"actions": {"onRun": _action([*place, *template, *job.words, "--openjd"], 60 * job.cut_minutes)}},
    }


def _report_step(job: BatchJob) -> Json:
    expected = [f"--expect={each.name}" for each in job.cuts]
    words = ["auto", "--report", "--output={{Param.OutputDir}}", *job.report_words, *expected]
    return {
        "name": _REPORT,
        "dependencies": [{"dependsOn": _CUTS}],
        "script": {"actions": {"onRun": _action(words, _REPORT_S)}},
    }


def _action(words: Sequence[str], timeout_s: int) -> Json:
    return {
        "command": "{{Param.Program}}",
        "args": list(words),
        "timeout": timeout_s,
        "cancelation": {"mode": "NOTIFY_THEN_TERMINATE", "notifyPeriodInSeconds": NOTICE_S},
    }


def _definitions(job: BatchJob) -> list[Json]:
    output = {
        "name": "OutputDir",
        "type": "PATH",
        "objectType": "DIRECTORY",
        "dataFlow": "OUT",
        "userInterface": shown_as("CHOOSE_DIRECTORY", "Output folder", _PLACES),
        "description": "Where each cut gets a folder, and the report.",
    }
    template = {
        "name": "TemplateFile",
        "type": "PATH",
        "objectType": "FILE",
        "dataFlow": "IN",
        "userInterface": shown_as("CHOOSE_INPUT_FILE", "Template", _PLACES),
        "description": "The Kagezou project whose light, looks, ground and set are taken.",
    }
    program = {
        "name": "Program",
        "type": "STRING",
        "default": job.program,
        "userInterface": shown_as("LINE_EDIT", "Program", "Workers"),
        "description": "How Kagezou is called on the workers: a name, or the path of the program.",
    }
    return [output, *([] if job.template is None else [template]), program]


def _values(job: BatchJob) -> list[Json]:
    template = [] if job.template is None else [{"name": "TemplateFile", "value": str(job.template)}]
    return [{"name": "OutputDir", "value": str(job.output)}, *template]


def _assets(job: BatchJob) -> Json:
    """Return what must be there on a worker: the cuts as they are, and the template."""
    files = [str(each.path) for each in job.cuts if not each.path.is_dir()]
    # What a timesheet times, or times a file of layers, lies beside it.
    folders = sorted({str(each.path if each.path.is_dir() else each.path.parent) for each in job.cuts})
    template = [] if job.template is None else [str(job.template)]
    return {
        "inputs": {"filenames": [*files, *template], "directories": folders},
        "outputs": {"directories": [str(job.output)]},
        "referencedPaths": [],
    }
