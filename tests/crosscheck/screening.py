"""The rules of schemas/hand-profile-v1.md for the HDF5 content of a profile as such, whatever its datasets mean."""

import h5py
import numpy as np

MAX_DEPTH = 4
MAX_OBJECTS = 2000
MAX_ROWS = 2**20
MAX_BYTES = 2**28


class Screening:
    def __init__(self, file):
        self.objects = self.bytes = 0
        self.visit_attributes(file)
        self.visit_group(file, 1)

    def visit_group(self, group, depth):
        for name in group:
            path = f"{group.name.rstrip('/')}/{name}"
            if not isinstance(group.get(name, getlink=True), h5py.HardLink):
                raise ValueError(f"{path} is no hard link")
            item = group[name]
            self.count_object(path)
            self.visit_attributes(item)
            if isinstance(item, h5py.Dataset):
                self.visit_dataset(item)
            elif isinstance(item, h5py.Group) and depth <= MAX_DEPTH:
                self.visit_group(item, depth + 1)
            else:
                raise ValueError(f"{path} is nested too deep or neither a group nor a dataset")

    def visit_attributes(self, item):
        for name in item.attrs:
            self.count_object(item.name)
            attribute = item.attrs.get_id(name)
            self.check_values(f"attribute {name} of {item.name}", attribute.dtype, attribute.shape, attribute.get_type())

    def visit_dataset(self, dataset):
        self.check_values(dataset.name, dataset.dtype, dataset.shape, dataset.id.get_type())
        creation = dataset.id.get_create_plist()
        filters = {creation.get_filter(i)[0] for i in range(creation.get_nfilters())}
        if dataset.is_virtual or dataset.external:
            raise ValueError(f"{dataset.name} is stored in other files")
        if filters - {h5py.h5z.FILTER_DEFLATE}:
            raise ValueError(f"{dataset.name} has other filters than deflate")

    def check_values(self, path, dtype, shape, type_id):
        if dtype.kind not in "iufS" or (dtype.kind == "S" and type_id.is_variable_str()):
            raise ValueError(f"{path} is of another type than numbers and fixed-length strings")
        if shape is None or (shape and shape[0] > MAX_ROWS):
            raise ValueError(f"{path} has no values or too many rows")
        self.bytes += dtype.itemsize * int(np.prod(shape, dtype=object))
        if self.bytes > MAX_BYTES:
            raise ValueError(f"{path} is too large")

    def count_object(self, path):
        self.objects += 1
        if self.objects > MAX_OBJECTS:
            raise ValueError(f"{path} is one object too many")


def screen(file):
    """Raises ValueError unless the open `file` holds only what the format allows."""
    Screening(file)
