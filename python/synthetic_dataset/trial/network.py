"""The network: a small Ultralytics detector, trained for a given time. Needs torch and ultralytics."""
import collections
import concurrent.futures
import copy
import math
import os
import time

import numpy as np
import torch
import torchvision
from torch.optim.swa_utils import AveragedModel
from ultralytics import YOLO
from ultralytics.cfg import get_cfg
from ultralytics.nn.tasks import DetectionModel

from synthetic_dataset.trial import samples
from synthetic_dataset.trial.precision import Found

FROM_NOTHING = 'yolov8n.yaml'  # a network description that comes with Ultralytics, without weights
WARM_UP = 40  # steps in which the learning rate rises
LAST_RATE = 0.02  # final learning rate, as a share of the full one
OF_FOUR_UNTIL = 0.85  # share of the time after which samples are no longer mosaics of four pictures
FROZEN = 5  # layers that keep the given weights if there is no GPU, which halves the time of a step
AVERAGED = 0.995  # share of the running mean that is kept in each step, after the first ones
LEAST_SCORE, MOST_FOUND = 0.001, 300
SAME = 0.6  # overlap above which two boxes count as one
PREPARED = 3  # batches that are prepared in advance
NO_NETWORK = 'holds no network of Ultralytics (a file such as yolov8n.pt)'

Options = collections.namedtuple('Options', 'size batch rate')
# With a GPU's options, a CPU would not get through the pictures once in the few minutes of a training.
ON_GPU, ON_CPU = Options(416, 48, 0.002), Options(256, 12, 0.0015)


class WeightsError(Exception):
    """Weights that cannot be used."""


class Network:
    """A detector for some classes."""

    def __init__(self, class_numbers, weights=None):
        """@param weights  an Ultralytics file with a network to start from
        @throws WeightsError"""
        torch.manual_seed(0)
        earlier = _loaded(weights) if weights else None
        self._classes = np.array(sorted(class_numbers))
        self._model = DetectionModel(copy.deepcopy(earlier.yaml) if earlier else FROM_NOTHING,
                                     nc=len(self._classes), verbose=False)
        if earlier is not None:
            self._model.load(earlier, verbose=False)
        self._model.args = get_cfg()
        self._device = torch.device('cuda' if torch.cuda.is_available() else 'cpu')
        self._model.to(self._device)
        self._is_on_gpu = self._device.type == 'cuda'
        self._options = ON_GPU if self._is_on_gpu else ON_CPU
        self._frozen = [] if earlier is None or self._is_on_gpu else list(self._model.model[:FROZEN])

    @property
    def size(self):
        """The longer side to which it scales a picture [px]."""
        return self._options.size

    @property
    def device(self):
        """The hardware on which it is trained, in words."""
        if self._is_on_gpu:
            return torch.cuda.get_device_name()
        count = torch.get_num_threads()
        return f"{count} thread{'s' if count > 1 else ''} of the CPU"

    def train(self, pictures, seconds, is_stopped, progress):
        """Trains for some seconds, or until it is stopped. Its weights are then their running mean over the steps.

        @param progress  is called after each step with its number, the seconds so far and the loss
        @return  the number of steps
        """
        optimizer = self._optimizer()
        mean = AveragedModel(self._model, avg_fn=_averaged, use_buffers=True)
        batches = Batches(pictures, self._options, self._classes)
        began, step = time.monotonic(), 0
        with batches:
            while True:
                share = (time.monotonic() - began) / seconds
                if share >= 1 or is_stopped():
                    break
                for group in optimizer.param_groups:
                    group['lr'] = self._options.rate * _rate_at(share, step)
                loss = self._loss(*batches.next(share < OF_FOUR_UNTIL))
                optimizer.zero_grad(set_to_none=True)
                loss.backward()
                torch.nn.utils.clip_grad_norm_(self._model.parameters(), 10.0)
                optimizer.step()
                mean.update_parameters(self._model)
                step += 1
                progress(step, time.monotonic() - began, loss.item() / self._options.batch)
        if step:
            self._model = mean.module
        return step

    def _loss(self, pixels, rows):
        self._model.train()
        for layer in self._frozen:
            layer.eval()
        pixels, rows = (torch.from_numpy(each).to(self._device) for each in (pixels, rows))
        with torch.autocast('cuda', dtype=torch.bfloat16, enabled=self._is_on_gpu):
            return self._model.loss({'img': pixels.permute(0, 3, 1, 2).float() / 255, 'batch_idx': rows[:, 0],
                                     'cls': rows[:, 1:2], 'bboxes': rows[:, 2:]})[0].sum()

    def _optimizer(self):
        for layer in self._frozen:
            layer.requires_grad_(False)
        learnt = [each for each in self._model.parameters() if each.requires_grad]
        return torch.optim.AdamW([
            {'params': [each for each in learnt if each.ndim > 1], 'weight_decay': 5e-4},
            {'params': [each for each in learnt if each.ndim <= 1], 'weight_decay': 0.0}])

    def find(self, files, progress=lambda done: None):
        """Yields the detections in each file, as shares of the picture, or None if it cannot be read."""
        self._model.eval()
        for start in range(0, len(files), 4 * self._options.batch):
            some = files[start:start + 4 * self._options.batch]
            pictures = [_opened(file, self.size) for file in some]
            squares = [samples.letterboxed(each, self.size)[0] for each in pictures if each is not None]
            found = iter(self._found(np.stack(squares)) if squares else ())
            for picture in pictures:
                yield None if picture is None else _in_shares(next(found), picture, self.size)
            progress(start + len(some))

    @torch.no_grad()
    def _found(self, squares):
        out = self._model(torch.from_numpy(squares).to(self._device).permute(0, 3, 1, 2).float() / 255)
        out = (out[0] if isinstance(out, (tuple, list)) else out).float()
        if getattr(self._model.model[-1], 'end2end', False):  # corners, score and class of each detection
            corners, scores, classes = out[..., :4], out[..., 4], out[..., 5].long()
        else:  # centres and sizes, and a score for each class
            corners = torchvision.ops.box_convert(out[:, :4].transpose(1, 2), 'cxcywh', 'xyxy')
            scores, classes = out[:, 4:].max(dim=1)
        for row in zip(corners, scores, classes):
            likely = [each[row[1] > LEAST_SCORE] for each in row]
            kept = torchvision.ops.batched_nms(*likely, SAME)[:MOST_FOUND]
            corners_kept, scores_kept, classes_kept = (each[kept].cpu().numpy() for each in likely)
            yield Found(corners_kept, scores_kept, self._classes[classes_kept])


class Batches:
    """Batches of samples, which threads prepare while the network learns from an earlier one."""

    def __init__(self, pictures, options, classes):
        self._samples = samples.Samples(pictures, options.size)
        self._options, self._classes = options, classes
        self._pool = concurrent.futures.ThreadPoolExecutor(os.cpu_count())
        self._prepared = collections.deque()
        self._next = 0

    def __enter__(self):
        return self

    def __exit__(self, *_):
        for batch in self._prepared:
            for each in batch:
                each.cancel()
        self._pool.shutdown()

    def next(self, may_be_of_four):
        """(n x size x size x 3, rows of [sample, class, x, y, width, height] in shares)."""
        while len(self._prepared) < PREPARED:
            numbers = range(self._next, self._next + self._options.batch)
            self._prepared.append([self._pool.submit(self._samples.sample, number, may_be_of_four)
                                   for number in numbers])
            self._next = numbers.stop
        pixels, truths = zip(*(each.result() for each in self._prepared.popleft()))
        rows = []
        for at, truth in enumerate(truths):
            low, high = truth[:, 1:3] / self._options.size, truth[:, 3:5] / self._options.size
            rows.append(np.column_stack((np.full(len(truth), at), np.searchsorted(self._classes, truth[:, 0]),
                                         (low + high) / 2, high - low)))
        return np.stack(pixels), np.concatenate(rows).astype(np.float32)


def _loaded(weights):
    try:
        model = YOLO(weights).model
    except Exception as error:  # the file may contain anything: unpickling may raise anything
        raise WeightsError(f"'{weights}': {NO_NETWORK}: {error}") from error
    if not isinstance(model, torch.nn.Module):  # for other file extensions, it is a name
        raise WeightsError(f"'{weights}': {NO_NETWORK}")
    if type(model) is not DetectionModel:  # models for masks and poses derive from it
        raise WeightsError(f"'{weights}': its network is a {type(model).__name__}; it should be one that finds boxes, such as "
                           'yolov8n.pt')
    return model


def _rate_at(share, step):
    cosine = 0.5 * (1 + math.cos(math.pi * share))
    return min(1.0, (step + 1) / WARM_UP) * (LAST_RATE + (1 - LAST_RATE) * cosine)


def _averaged(mean, now, steps):
    """The running mean, which keeps less of the first steps, as they are worse than later ones."""
    return mean + (now - mean) * (1 - min(AVERAGED, (1 + steps) / (10 + steps)))


def _opened(file, size):
    try:
        return samples.opened(file, size)
    except OSError:
        return None


def _in_shares(found, picture, size):
    """Converts boxes from pixels of the square to shares of the picture in its middle."""
    around = np.array([(size - side) // 2 for side in picture.size] * 2)
    corners = np.clip((found.boxes - around) / np.array(picture.size * 2), 0, 1)
    return found._replace(boxes=corners)
