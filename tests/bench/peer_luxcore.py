"""Renders a scene of peer_formats.write_luxcore with LuxCore's Python module on the processor.

    VENV/bin/python peer_luxcore.py SCENE.cfg THREADS SAMPLES SEED IMAGE.exr [PROPERTY=VALUE ...]

Prints a line "@@ SECONDS": from the start of the session, which builds hierarchies and caches, until all samples are there.
"""

import os
import pathlib
import sys
import time

import pyluxcore


def main():
    file, threads, samples, seed, image, *more = sys.argv[1:]
    image = str(pathlib.Path(image).resolve())
    os.chdir(pathlib.Path(file).resolve().parent)
    pyluxcore.Init(lambda message: None)
    properties = pyluxcore.Properties(pathlib.Path(file).name)
    settings = {"native.threads.count": int(threads), "renderengine.seed": int(seed) + 1, "batch.haltspp": [int(samples), 0],
                "path.russianroulette.depth": 3, "path.russianroulette.cap": 0.5}
    for key, value in settings.items():
        properties.Set(pyluxcore.Property(key, value))
    for setting in more:
        key, _, value = setting.partition("=")
        properties.Set(pyluxcore.Property(key, value))
    session = pyluxcore.RenderSession(pyluxcore.RenderConfig(properties))
    begin = time.perf_counter()
    session.Start()
    while not session.HasDone():
        time.sleep(0.01)
        session.UpdateStats()
    seconds = time.perf_counter() - begin
    session.Stop()
    session.GetFilm().SaveOutput(image, pyluxcore.FilmOutputType.RGB, pyluxcore.Properties())
    print(f"\n@@ {seconds:.3f}", flush=True)
    os._exit(0)   # its own end crashes at times


main()
