"""After an export: put the video, or else the first composite, on the shot's Shadow task of Kitsu.

KITSU_HOST and KITSU_TOKEN say where and who; the cut's name, scene and cut are project, sequence and shot.
"""

import json
import os
import sys
from pathlib import Path
from typing import Any

import gazu

manifest: dict[str, Any] = json.loads(Path(sys.argv[-1]).read_text(encoding="utf-8"))
cut = manifest["project"]
found = [each for kind in ("video", "composite") for each in manifest["files"] if each["kind"] == kind]
if not found:
    sys.exit("there is neither a video nor a composite to publish")

gazu.set_host(os.environ["KITSU_HOST"])
gazu.set_token(os.environ["KITSU_TOKEN"])
project = gazu.project.get_project_by_name(cut["name"])
sequence = gazu.shot.get_sequence_by_name(project, cut["scene"])
shot = gazu.shot.get_shot_by_name(sequence, cut["cut"])
task = gazu.task.get_task_by_entity(shot, gazu.task.get_task_type_by_name("Shadow"))
status = gazu.task.get_task_status_by_short_name("wfa")
words = f"Kagezou {manifest['program']['version']}, {len(manifest['files'])} files, project {cut['sha256'][:12]}"
gazu.task.publish_preview(task, status, words, preview_file_path=found[0]["path"])
sys.stdout.write(f"published {found[0]['path']}\n")
