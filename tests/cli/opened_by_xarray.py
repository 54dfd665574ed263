# opened_by_xarray.py FOLDER: opens the sweep.h5 of a grid of angles as users of xarray do, and compares with sweep.csv.
import csv
import sys

import xarray

folder = sys.argv[1]
with open(f"{folder}/sweep.csv", encoding="utf-8") as table:
    rows = list(csv.DictReader(line for line in table if not line.startswith("#")))
with xarray.open_dataset(f"{folder}/sweep.h5") as sweep:
    assert sweep.sigma.dims == ("elevation", "azimuth"), sweep.sigma.dims
    for name, unit in {"sigma": "m2", "bound": "m2", "azimuth": "degree", "facet_sigma": "m2", "area": "m2"}.items():
        assert sweep[name].attrs["units"] == unit, name
    for row in rows:
        angles = {"azimuth": float(row["transmitter_azimuth_deg"]), "elevation": float(row["transmitter_elevation_deg"])}
        assert sweep.sigma.sel(angles).item() == float(row["sigma_m2"]), row
        assert sweep.bound.sel(angles).item() == float(row["bound_m2"]), row
    shares = sweep.facet_sigma.sum("facet")
    for row in sweep.facet_row.values:
        sigma = float(rows[row]["sigma_m2"])
        assert abs(shares.sel(facet_row=row).item() - sigma) <= 1e-12 * sigma, row
    by_part = sweep.facet_sigma.groupby(sweep.part).sum()
    assert by_part.sizes["part"] == sweep.part_name.size, by_part.sizes
    assert sweep.part_name.values[0] in (b"body", "body"), sweep.part_name.values
