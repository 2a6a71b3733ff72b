"""Parquet: trajectories.parquet, all flights of a run in one table with a column `flight`; results.parquet, the table of a batch.

Units stand in the metadata of each column, config.yaml and summary.json (of a batch manifest.json) in that of the table.
"""
import json
import os

import numpy as np

from .flights import Missing, unit, write_whole


def load_pyarrow():
    try:
        import pyarrow.csv
        import pyarrow.parquet
    except ImportError as error:
        raise Missing("--parquet needs %s; run: scripts/setup" % error.name)
    return pyarrow


def write_batch(batch, folder):
    """results.csv of a batch, types as its values have them; an empty field is null."""
    pyarrow = load_pyarrow()
    convert = pyarrow.csv.ConvertOptions(strings_can_be_null=True, true_values=["true"], false_values=["false"])
    table = pyarrow.csv.read_csv(batch.table, convert_options=convert)
    table = table.replace_schema_metadata({"manifest.json": batch.manifest})
    return [write_whole(os.path.join(folder, "results.parquet"), lambda path: pyarrow.parquet.write_table(table, path))]


def write(run, folder):
    pyarrow = load_pyarrow()
    tables = []
    for flight in run.flights:
        columns, fields = [pyarrow.array([flight.name] * len(flight["k"])).dictionary_encode()], [pyarrow.field(
            "flight", pyarrow.dictionary(pyarrow.int32(), pyarrow.string()))]
        for name, values in flight.columns.items():
            if name == "phase":
                column = pyarrow.array(list(values)).dictionary_encode()
            elif name == "k":
                column = pyarrow.array(values.astype(np.int64))
            else:
                column = pyarrow.array(values, from_pandas=True)   # NaN: there is no such value
            columns.append(column)
            fields.append(pyarrow.field(name, column.type, metadata={"unit": unit(name)}))
        tables.append(pyarrow.Table.from_arrays(columns, schema=pyarrow.schema(fields)))
    table = pyarrow.concat_tables(tables).unify_dictionaries()
    table = table.replace_schema_metadata({"config.yaml": run.config_text, "summary.json": json.dumps(run.summary)})
    return [write_whole(os.path.join(folder, "trajectories.parquet"), lambda path: pyarrow.parquet.write_table(table, path))]
